// Repeats a recorded run from its trace, in virtual time.
#pragma once

#include <ostream>

#include "symplant/host/read_replay.hpp"
#include "symplant/host/stage.hpp"

namespace symplant::host {

/// False, with a message on `err`, if an option contradicts `--replay`.
bool replay_fits(const RunOptions& options, std::ostream& err);

/// The options of a run that repeats a trace: in virtual time, with the seed of the trace unless another one is given.
RunOptions options_of_replay(RunOptions options, const Replay& replay);

/// Warns if the replay may differ from the recorded run.
void report_other_run(const Stage& stage, const RunOptions& options, const Replay& replay, std::ostream& err);

/// Repeats the recorded run from time 0 until the trace ends, `--until` is reached or a signal comes; the reason goes
/// to `out`. The plant must not have run.
void run_replay(Stage& stage, const Replay& replay, const RunOptions& options, std::ostream& out);

}  // namespace symplant::host

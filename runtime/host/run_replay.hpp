// Runs a plant as a trace has it, in virtual time.
#pragma once

#include <ostream>

#include "symplant/host/read_replay.hpp"
#include "symplant/host/stage.hpp"

namespace symplant::host {

/// Repeats the recorded run from time 0 until the trace ends, `--until` is reached or a signal comes; the reason goes
/// to `out`. The plant must not have run.
void run_replay(Stage& stage, const Replay& replay, const RunOptions& options, std::ostream& out);

}  // namespace symplant::host

// A run in real time, beside a PLC.
#pragma once

#include <ostream>
#include <vector>

#include "symplant/exec/cycle_meter.hpp"
#include "symplant/exec/real_time.hpp"
#include "symplant/exec/thread_faults.hpp"
#include "symplant/host/console.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/host/stage.hpp"

namespace symplant::host {

/// What a run in real time came to.
struct RealRun {
  exec::CycleStatistics cycles;
  exec::ThreadFaults faults;           ///< of the cycle's thread, in its cycles
  bool asked = false;                  ///< for priority, processor or locked memory
  std::vector<exec::Refusal> refused;  ///< of these
  bool clean = true;                   ///< with --rt-check: nothing was done that a cycle must not do
};

/// From where the plant stands, in step with the wall clock, to `--until`, else to the last step of the scenario, or to
/// a signal; with `--rt-check` so many cycles under the guard, of a plant made of exec::WatchedBehaviours. Tells on
/// `out` what runs, how it ended, and what the cycle and the links came to; on `err` what the system refused; while it
/// runs it tells on `console`, which is made of both.
RealRun run_real(Stage& stage, const RunOptions& options, const Links& links, Console& console, std::ostream& out,
                 std::ostream& err);

}  // namespace symplant::host

// Runs a plant in real time, against a PLC.
#pragma once

#include <vector>

#include "symplant/exec/cycle_meter.hpp"
#include "symplant/exec/real_time.hpp"
#include "symplant/exec/thread_faults.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/plc_clock.hpp"
#include "symplant/host/plc_verdict.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/host/stage.hpp"

namespace symplant::host {

/// The result of a run in real time.
struct RealRun {
  exec::CycleStatistics cycles;
  exec::ThreadFaults faults;           ///< of the cycle's thread, during the cycles
  bool asked = false;                  ///< whether a real-time setting was requested
  std::vector<exec::Refusal> refused;  ///< settings that the system refused
  bool clean = true;                   ///< with --rt-check: the guard found nothing
  PlcVerdict plcs;
};

/// Runs from the current plant time to `--until`, else to the last step of the scenario, or to a signal; with
/// `--rt-check` for that many cycles under the guard (the plant must be made of exec::WatchedBehaviours). Plant time
/// follows `clock`, or the wall clock if it is null. `panel` may be null. Reports on `streams.report` the links, the
/// end, and statistics of the cycle and the links; on `streams.err` the settings that the system refused.
RealRun run_real(Stage& stage, const RunOptions& options, const Links& links, const PlcClockChoice* clock,
                 panel::Panel* panel, const RunStreams& streams);

}  // namespace symplant::host

// The verdict on the PLCs of a run in real time: whether they connected, and whether plant time ran.
#pragma once

#include <string>

#include "symplant/exec/cycle_meter.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/plc_clock.hpp"
#include "symplant/host/stage.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::host {

/// Each text says what happened and what to check; empty: it did not happen.
struct PlcVerdict {
  std::string unreached;  ///< a link that goes to a PLC never had a connection
  std::string stalled;    ///< plant time did not run, or waited until the end for a PLC
};

/// To be called once the cycle has ended, by the thread that ended it. A link whose PLC has exchanged nothing becomes
/// the finding `no PLC`. `clock` may be null; `gave_up`: the run ended before plant time reached its end.
PlcVerdict judge_plcs(Stage& stage, const Links& links, const PlcClockChoice* clock,
                      const exec::CycleStatistics& cycles, bool gave_up);

}  // namespace symplant::host

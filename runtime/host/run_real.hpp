// A run in real time, beside a PLC.
#pragma once

#include <ostream>

#include "symplant/exec/cycle.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/host/stage.hpp"

namespace symplant::host {

/// From where the plant stands, in step with the wall clock, to `--until`, else to the last step of the scenario, or to
/// a signal. Tells on `out` what runs, how it ended, and what the cycle and the links came to.
exec::CycleStatistics run_real(Stage& stage, const RunOptions& options, const Links& links, std::ostream& out);

}  // namespace symplant::host

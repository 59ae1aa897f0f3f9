// A run in real time, beside a PLC.
#pragma once

#include <ostream>

#include "symplant/core/plant.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/outputs.hpp"
#include "symplant/host/run_options.hpp"

namespace symplant::host {

/// From where the plant stands, in step with the wall clock, to `--until` or a signal. Tells on `out` what runs, how it
/// ended, and what the cycle and the links came to.
void run_real(core::Plant& plant, const RunOptions& options, const Links& links, Outputs& outputs, std::ostream& out);

}  // namespace symplant::host

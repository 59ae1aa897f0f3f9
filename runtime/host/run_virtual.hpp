// Runs a plant in virtual time, as fast as possible.
#pragma once

#include <ostream>

#include "symplant/host/run_options.hpp"
#include "symplant/host/stage.hpp"

namespace symplant::host {

/// Runs from the current plant time to `--until`, else to the last step of the scenario, else until nothing more is
/// due, at most one hour of plant time. Reports the end on `out`.
void run_virtual(Stage& stage, const RunOptions& options, std::ostream& out);

}  // namespace symplant::host

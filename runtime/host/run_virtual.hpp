// A run in virtual time: as fast as it goes.
#pragma once

#include <ostream>

#include "symplant/host/run_options.hpp"
#include "symplant/host/stage.hpp"

namespace symplant::host {

/// From where the plant stands to `--until`, else to the last step of the scenario, else until nothing more is due, at
/// the latest after an hour of plant time. Tells on `out` how it ended.
void run_virtual(Stage& stage, const RunOptions& options, std::ostream& out);

}  // namespace symplant::host

// A run in virtual time: as fast as it goes.
#pragma once

#include <ostream>

#include "symplant/core/plant.hpp"
#include "symplant/host/outputs.hpp"
#include "symplant/host/run_options.hpp"

namespace symplant::host {

/// From where the plant stands to `--until`, else until nothing more is due, at the latest after an hour of plant time.
/// Tells on `out` how it ended.
void run_virtual(core::Plant& plant, const RunOptions& options, Outputs& outputs, std::ostream& out);

}  // namespace symplant::host

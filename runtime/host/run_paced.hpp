// Runs a plant in step with the clock, at the speed that its panel asks for.
#pragma once

#include <iosfwd>

#include "symplant/host/run_options.hpp"
#include "symplant/host/stage.hpp"
#include "symplant/panel/panel.hpp"

namespace symplant::host {

/// Runs the plant without a link to a PLC until a signal or `options.until`. Once per `options.cycle` of the clock it
/// advances plant time by `options.cycle` times the speed of the panel. If the plant is slower than that, it runs as
/// fast as possible.
void run_paced(Stage& stage, const RunOptions& options, panel::Panel& panel, std::ostream& out);

}  // namespace symplant::host

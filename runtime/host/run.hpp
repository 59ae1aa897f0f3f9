// Runs a plant: the same for generated tables and for those made at run time.
#pragma once

#include <iosfwd>

#include "symplant/host/plant_program.hpp"
#include "symplant/host/run_options.hpp"

namespace symplant::host {

/// Tells what the plant is, then runs it by the options until it ends or a signal (SIGINT, SIGTERM) comes. Results go
/// to `out`, messages to `err`. Gives the exit code.
int run(const PlantProgram& program, const RunOptions& options, std::ostream& out, std::ostream& err);

}  // namespace symplant::host

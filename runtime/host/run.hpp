// Runs a plant, from generated tables or from tables made at run time.
#pragma once

#include <iosfwd>

#include "symplant/host/plant_program.hpp"
#include "symplant/host/run_options.hpp"

namespace symplant::host {

/// Prints a summary of the plant, then runs it by the options until it ends or a signal (SIGINT, SIGTERM) comes.
/// Results go to `out`, messages to `err`. Returns the exit code.
int run(const PlantProgram& program, const RunOptions& options, std::ostream& out, std::ostream& err);

}  // namespace symplant::host

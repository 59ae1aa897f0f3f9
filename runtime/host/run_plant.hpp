// The main() of every generated plant.
#pragma once

#include "symplant/host/plant_program.hpp"

namespace symplant::host {

/// Parses the command line (the options of `symplant run`) and runs the plant. Returns the exit code.
int run_plant(int argc, char** argv, const PlantProgram& program);

}  // namespace symplant::host

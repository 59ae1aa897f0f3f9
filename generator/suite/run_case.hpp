// Runs one case of a suite.
#pragma once

#include <string>
#include <vector>

#include "suite/reference.hpp"
#include "suite/result.hpp"
#include "suite/suite.hpp"
#include "symplant/host/plant_program.hpp"
#include "symplant/host/run_options.hpp"

namespace symplant::suite {

/// What all cases have in common.
struct Setup {
  const Suite& suite;
  host::RunOptions run;  ///< programs, links
  bool update = false;   ///< write reference traces
};

/// Runs a case on a plant with this speed, in this process, which ends if a program crashes. `trace` is a file that
/// it may write, and that does not exist afterwards.
Result run_case(const Setup& setup, const host::PlantProgram& plant, const std::string& name, Speed speed,
                const std::string& trace);

}  // namespace symplant::suite

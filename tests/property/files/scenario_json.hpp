// A scenario as a file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "property/files/counts.hpp"
#include "property/files/file_case.hpp"

namespace symplant::property::files {

/// For each step the number, from 0, of the step in the file: those of later turns are those of the first.
std::vector<std::size_t> numbers_in_file(const std::vector<Step>& steps);

/// Steps name symbols of `plant`.
std::string scenario_json(const std::vector<Step>& steps, const model::PlantModel& plant, const Style& style,
                          Counts& counts);

}  // namespace symplant::property::files

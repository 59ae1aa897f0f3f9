// A scenario as a file.
#pragma once

#include <string>

#include "property/files/counts.hpp"
#include "property/files/file_case.hpp"

namespace symplant::property::files {

/// Steps name symbols of `plant`.
std::string scenario_json(const std::vector<Step>& steps, const model::PlantModel& plant, const Style& style,
                          Counts& counts);

}  // namespace symplant::property::files

// Reads a scenario file against a plant.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "symplant/json/location.hpp"
#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::scenario {

struct ReadScenario {
  std::optional<Scenario> scenario;  ///< present if there are no faults
  std::vector<json::Placed> faults;  ///< all faults, in the order of the text
};

/// `carried`: for each symbol, whether it is an operation that a link to a PLC writes, which a scenario cannot set;
/// empty if there is no such operation. O(text + plant).
ReadScenario read_scenario(std::string_view text, const trace::PlantNames& names, const std::vector<bool>& carried);

/// The JSON Schema of the format (draft-07), as `symplant schema scenario` prints it.
std::string_view scenario_schema();

}  // namespace symplant::scenario

// Which units a change concerns.
#pragma once

#include <cstdint>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::observe {

/// The units that must be looked at again after a change.
struct Dependents {
  std::vector<std::vector<std::uint32_t>> of_symbol;  ///< by symbol: units with a condition that reads it
  std::vector<std::vector<std::uint32_t>> of_unit;    ///< by unit: units with a condition on it, or that it disables
  std::vector<std::vector<std::uint32_t>> read_by;  ///< by unit: the units on which it depends, the reverse of of_unit
};

/// O(conditions and disables).
Dependents dependents_of(const model::PlantModel& plant);

}  // namespace symplant::observe

// Inverse references of a model: what disables a unit, which requirements name it.
#pragma once

#include <cstdint>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::view {

/// A unit is disabled while another is settled in one of its states.
struct Disabler {
  std::uint32_t unit;
  std::uint32_t state;
};

struct CrossReferences {
  std::vector<std::vector<Disabler>> disabled_by;        ///< of each unit, by unit and state
  std::vector<std::vector<std::uint32_t>> requirements;  ///< of each unit: those that name it or a symbol of it
};

/// O(the whole model).
CrossReferences cross_references(const model::PlantModel& plant);

}  // namespace symplant::view

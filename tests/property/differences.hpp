// The difference between engine and reference, as text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/plant_model.hpp"
#include "property/engine_plant.hpp"
#include "support/reference/reference.hpp"

namespace symplant::property {

// Each function returns the first difference, empty if there is no difference.
std::string instants_difference(const EnginePlant& engine, const reference::Plant& reference,
                                const model::PlantModel& plant);
std::string state_difference(EnginePlant& engine, const reference::Plant& reference, const model::PlantModel& plant);
/// Compares all that two plants show after the same actions, and takes their findings.
std::string twin_difference(EnginePlant& engine, EnginePlant& twin);
std::string next_due_difference(plant::Plant& engine, const reference::Plant& reference);

/// What the engine showed before an advance, to check that it reports all changes after it.
class Shadow {
 public:
  Shadow(const EnginePlant& engine, const model::PlantModel& plant);
  std::string difference(const EnginePlant& engine) const;

 private:
  const model::PlantModel& plant_;
  std::vector<plant::UnitView> units_;
  std::vector<std::uint64_t> events_;
  std::vector<std::uint64_t> values_;
};

}  // namespace symplant::property

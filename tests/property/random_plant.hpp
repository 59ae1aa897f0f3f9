// Random valid plants, and random actions on them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "property/dice.hpp"
#include "property/plant_text.hpp"

namespace symplant::property {

struct DrawnPlant {
  PlantText text;
  model::PlantModel model;
  int refused = 0;            ///< rejected plans before this one
  std::string first_refusal;  ///< the reason for the first rejection
};

struct DrawOptions {
  bool behaviours = true;
  std::size_t most_units = 1000;
  bool naming_rules = true;  ///< some plants have a custom naming rule
  bool material = true;      ///< some plants have material flow
  bool malfunctions = true;  ///< some plants have written malfunctions
  bool values = true;        ///< some plants have values and signals
};

/// The same plant for the same seed and options, everywhere.
DrawnPlant random_plant(std::uint64_t seed, const DrawOptions& options = {});

/// A value that is valid for a symbol of the type: 0 or 1, two's complement, or the bits of a double.
std::uint64_t random_content(Dice& dice, tables::DataType type);

/// The actions on a plant of this model, from a reset on.
std::vector<Action> random_stimulus(std::uint64_t seed, const model::PlantModel& plant);

}  // namespace symplant::property

// Devices of equal structure, and patterns that name just them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::emit {

/// Devices whose states, operations, events, actuation, rest and initial state are alike, and, up to eight kinds, the
/// name without the number at its end as well.
struct Shape {
  std::vector<std::uint32_t> units;  ///< ascending
  /// An exact path, or a pattern that fits all of `named` and no other device of the plant.
  std::string pattern;
  std::vector<std::uint32_t>
      named;  ///< those of `units` that the pattern fits; the others have no short name of their own
};

/// In the order of their first device. Where no pattern fits just the devices of a shape, it fits as many of them as
/// share the longest beginning with the first one, or is the path of the first alone. O(devices * shapes).
std::vector<Shape> shapes_of(const model::PlantModel& plant);

}  // namespace symplant::emit

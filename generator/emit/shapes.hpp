// Devices of equal structure, and patterns that match exactly these devices.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::emit {

/// Devices with equal states, operations, events, actuation, rest and initial state. Up to eight kinds of device (the
/// name without the number at its end) get separate shapes.
struct Shape {
  std::vector<std::uint32_t> units;  ///< ascending
  /// An exact path, or a pattern that matches all of `named` and no other device of the plant.
  std::string pattern;
  std::vector<std::uint32_t> named;  ///< those of `units` that the pattern matches; no short pattern covers the others
};

/// In the order of their first device. If no pattern matches exactly the devices of a shape, the pattern is the
/// shortest prefix of the first device that matches devices of the shape only, or its whole path. O(devices * shapes).
std::vector<Shape> shapes_of(const model::PlantModel& plant);

}  // namespace symplant::emit

// What a device looks like in the panel's plan.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace symplant::tables {

/// `device`: nothing suits; a plain box.
enum class Shape : std::uint8_t {
  device,
  button,
  clamp,
  conveyor,
  cylinder,
  door,
  gripper,
  lamp,
  lift,
  machine,
  motor,
  pump,
  robot,
  selector,
  sensor,
  tank,
  turntable,
  valve,
  vehicle,
};

/// By Shape.
inline constexpr std::array<std::string_view, 19> kShapeNames{
    "device", "button", "clamp", "conveyor", "cylinder", "door", "gripper",   "lamp",  "lift",   "machine",
    "motor",  "pump",   "robot", "selector", "sensor",   "tank", "turntable", "valve", "vehicle"};

constexpr std::string_view shape_name(Shape shape) { return kShapeNames[static_cast<std::size_t>(shape)]; }

/// Nothing for another text.
constexpr std::optional<Shape> shape_of_name(std::string_view name) {
  const auto found = std::find(kShapeNames.begin(), kShapeNames.end(), name);
  if (found == kShapeNames.end()) return std::nullopt;
  return static_cast<Shape>(found - kShapeNames.begin());
}

}  // namespace symplant::tables

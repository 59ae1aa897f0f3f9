// The model of a device as items that can be compared one by one.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "diff/difference.hpp"

namespace symplant::diff {

/// A part of a model in words. Items of equal element and key are compared in their order.
struct Item {
  std::string_view element;
  std::string key;
  std::string value;
  std::array<std::string, 2> states = {};  ///< it exists only together with these; empty: none

  friend bool operator==(const Item&, const Item&) = default;
};

/// All that `symplant model` shows of a device, in its order. O(model).
std::vector<Item> items_of(const model::PlantModel& plant, const model::Unit& unit);

/// What the plant has besides devices: requirements, followed conditions, material, malfunctions.
std::vector<Item> plant_items(const model::PlantModel& plant);

/// What differs, in the order of `after`, then what was lost. O(n log n).
std::vector<ItemChange> item_changes(const std::vector<Item>& before, const std::vector<Item>& after);

}  // namespace symplant::diff

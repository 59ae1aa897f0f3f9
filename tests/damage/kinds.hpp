// Kinds of damage that manual editing does to a symbol list, and the rule that each must trigger.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "damage/shop_list.hpp"
#include "property/dice.hpp"

namespace symplant::damage {

using property::Dice;

/// A damaged list and the rows (indexes); the finding must be at one of them.
struct Damaged {
  ShopList list;
  std::vector<std::size_t> roots;
};

/// A clean list with what the kinds look for in it.
struct Shop {
  explicit Shop(ShopList clean) : list(std::move(clean)), devices(list.devices()) {}

  ShopList list;
  std::vector<Device> devices;
};

struct Kind {
  std::string_view name;
  std::string_view what;  ///< what was changed, for the table of the manual
  std::string_view rule;  ///< the slug of the rule that must fire
  /// At a random row. The list must have a suitable row.
  Damaged (*apply)(const Shop& shop, Dice& dice);
};

/// All of them, in the order of the table.
const std::vector<Kind>& kinds();

// By subject; each is a part of kinds().
std::vector<Kind> name_kinds();
std::vector<Kind> row_kinds();
std::vector<Kind> address_kinds();
std::vector<Kind> device_kinds();

/// A random row that fulfills `wanted`. Throws std::runtime_error if there is no such row.
template <class Wanted>
std::size_t pick_row(const Shop& shop, Dice& dice, Wanted&& wanted);
template <class Wanted>
const Device& pick_device(const Shop& shop, Dice& dice, Wanted&& wanted);

std::size_t pick_place(const std::vector<std::size_t>& indexes, Dice& dice);

template <class Wanted>
std::size_t pick_row(const Shop& shop, Dice& dice, Wanted&& wanted) {
  std::vector<std::size_t> indexes;
  for (std::size_t i = 0; i < shop.list.rows.size(); ++i) {
    const auto levels = levels_of(shop.list.rows[i].name);
    if (levels && wanted(shop.list.rows[i], *levels)) indexes.push_back(i);
  }
  return pick_place(indexes, dice);
}

template <class Wanted>
const Device& pick_device(const Shop& shop, Dice& dice, Wanted&& wanted) {
  std::vector<std::size_t> indexes;
  for (std::size_t i = 0; i < shop.devices.size(); ++i) {
    if (wanted(shop.devices[i])) indexes.push_back(i);
  }
  return shop.devices[pick_place(indexes, dice)];
}

}  // namespace symplant::damage

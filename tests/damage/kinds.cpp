// All kinds of damage.
#include "damage/kinds.hpp"

#include <stdexcept>

namespace symplant::damage {
namespace {

std::vector<Kind> all_kinds() {
  std::vector<Kind> all;
  for (const auto& part : {name_kinds(), row_kinds(), address_kinds(), device_kinds()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = all_kinds();
  return all;
}

std::size_t pick_place(const std::vector<std::size_t>& indexes, Dice& dice) {
  if (indexes.empty()) throw std::runtime_error("the list has no place for this kind of damage");
  return dice.pick(indexes);
}

}  // namespace symplant::damage

// Symbols that share an address.
#include "property/files/shared_symbols.hpp"

#include <algorithm>

namespace symplant::property::files {
namespace {

std::uint32_t leader_of(const model::PlantModel& plant, std::uint32_t symbol) {
  const std::uint32_t leader = plant.symbols[symbol].leader;
  return leader == model::kNone ? symbol : leader;
}

}  // namespace

bool may_be_driven_by_code(const model::PlantModel& plant, std::uint32_t symbol) {
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const std::uint32_t unit = plant.symbols[i].unit;
    if (leader_of(plant, i) != leader_of(plant, symbol) || unit == model::kNone) continue;
    if (plant.units[unit].has_behaviour()) return true;
  }
  return false;
}

bool shares_an_address(const model::PlantModel& plant, std::uint32_t unit) {
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const std::uint32_t leader = plant.symbols[i].leader;
    if (leader != model::kNone && (plant.symbols[i].unit == unit || plant.symbols[leader].unit == unit)) return true;
  }
  return false;
}

}  // namespace symplant::property::files

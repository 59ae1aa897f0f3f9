// Symbols that stand on one address.
#include "model/shared_addresses.hpp"

#include <algorithm>
#include <unordered_map>

#include "model/classify.hpp"

namespace symplant::model {
namespace {

/// Addresses are unique within a controller.
struct Place {
  std::uint32_t controller;
  address::Address address;

  bool operator==(const Place&) const = default;
};

struct HashPlace {
  std::size_t operator()(const Place& place) const {
    const address::Address& a = place.address;
    const std::uint64_t kind = static_cast<std::uint64_t>(place.controller) << 16 |
                               static_cast<std::uint64_t>(a.area) << 8 | static_cast<std::uint64_t>(a.size);
    return static_cast<std::size_t>((a.number * 2 + (a.plain ? 1 : 0)) * 0x9E37'79B9'7F4A'7C15 ^ kind);
  }
};

/// Where type and address differ in size the symbol has no place there (a check tells), so that it shares none.
bool has_place(const Symbol& symbol) {
  return symbol.address && static_cast<int>(symbol.address->size) == data_type_bits(symbol.type);
}

bool moved(const PlantModel& plant, std::uint32_t index) {
  const Symbol& symbol = plant.symbols[index];
  if (symbol.direction != core::Direction::event || symbol.unit == kNone) return false;
  const Unit& unit = plant.units[symbol.unit];
  const auto place = std::find(unit.events.begin(), unit.events.end(), index) - unit.events.begin();
  return unit.moves_event(static_cast<std::uint32_t>(place));
}

}  // namespace

void find_shared_addresses(PlantModel& plant) {
  std::unordered_map<Place, std::uint32_t, HashPlace> leaders;
  leaders.reserve(plant.symbols.size());
  bool any = false;
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const Symbol& symbol = plant.symbols[i];
    if (!has_place(symbol)) continue;
    const auto [found, added] = leaders.try_emplace({plant.controller_of(symbol), *symbol.address}, i);
    if (added) continue;
    any = true;
    if (!moved(plant, i)) continue;
    if (!moved(plant, found->second)) {
      found->second = i;
    } else if (plant.symbols[found->second].unit != symbol.unit) {
      plant.moved_twice.push_back({i, found->second});
    }
  }
  if (!any) return;
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    Symbol& symbol = plant.symbols[i];
    if (!has_place(symbol)) continue;
    const std::uint32_t leader = leaders.find({plant.controller_of(symbol), *symbol.address})->second;
    if (leader != i) symbol.leader = leader;
  }
}

}  // namespace symplant::model

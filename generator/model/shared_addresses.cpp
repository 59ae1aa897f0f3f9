// Finds symbols that share an address.
#include "model/shared_addresses.hpp"

#include <algorithm>

#include "base/index_table.hpp"
#include "model/classify.hpp"

namespace symplant::model {
namespace {

/// Addresses are unique within a controller.
struct Location {
  std::uint32_t controller = 0;
  address::Address address;

  bool operator==(const Location&) const = default;
};

std::uint64_t hash_of(const Location& position) {
  const address::Address& a = position.address;
  const std::uint64_t kind = static_cast<std::uint64_t>(position.controller) << 16 |
                             static_cast<std::uint64_t>(a.area) << 8 | static_cast<std::uint64_t>(a.size);
  return (a.number * 2 + (a.plain ? 1 : 0)) * 0x9E37'79B9'7F4A'7C15 ^ kind * 0xC2B2'AE3D'27D4'EB4F;
}

/// False if the address is not assigned, or if type and address differ in size, which a check reports: then the symbol
/// shares no address.
bool has_index(const Symbol& symbol) {
  return symbol.address && symbol.address->assigned &&
         static_cast<int>(symbol.address->size) == data_type_bits(symbol.type);
}

bool moved(const PlantModel& plant, std::uint32_t index) {
  const Symbol& symbol = plant.symbols[index];
  if (symbol.driven_without_unit()) return true;
  if (symbol.direction != tables::Direction::event || symbol.unit == kNone) return false;
  const Unit& unit = plant.units[symbol.unit];
  const auto position = std::find(unit.events.begin(), unit.events.end(), index) - unit.events.begin();
  return unit.moves_event(static_cast<std::uint32_t>(position));
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> find_shared_addresses(PlantModel& plant) {
  std::vector<std::array<std::uint32_t, 2>> driven_twice;
  const auto location_of = [&](const Symbol& symbol) { return Location{plant.controller_of(symbol), *symbol.address}; };
  base::IndexTable leaders(plant.symbols.size());
  const auto is_at = [&](const Location& position) {
    return [&](std::uint32_t other) { return location_of(plant.symbols[other]) == position; };
  };
  const auto fetch = [&](std::size_t i) {
    if (i < plant.symbols.size() && has_index(plant.symbols[i]))
      leaders.prefetch(hash_of(location_of(plant.symbols[i])));
  };
  constexpr std::size_t kAhead = 12;  // symbols: enough time for an access to memory
  bool any = false;
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    fetch(std::size_t{i} + kAhead);
    const Symbol& symbol = plant.symbols[i];
    if (!has_index(symbol)) continue;
    const Location position = location_of(symbol);
    const std::uint64_t hash = hash_of(position);
    const std::uint32_t leader = leaders.find_or_add(hash, i, is_at(position));
    if (leader == i) continue;
    any = true;
    if (!moved(plant, i)) continue;
    if (!moved(plant, leader)) {
      leaders.move(hash, i, is_at(position));
    } else if (plant.symbols[leader].unit != symbol.unit || symbol.unit == kNone) {
      driven_twice.push_back({i, leader});
    }
  }
  for (const auto& [second, first] : driven_twice) plant.symbols[second].address.reset();
  if (!any) return driven_twice;
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    Symbol& symbol = plant.symbols[i];
    if (!has_index(symbol)) continue;
    const Location position = location_of(symbol);
    const std::uint32_t leader = leaders.find(hash_of(position), is_at(position));
    if (leader != i) symbol.leader = leader;
  }
  return driven_twice;
}

}  // namespace symplant::model

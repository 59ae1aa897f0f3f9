// Works out which symbols stand on one address.
#include "symplant/engine/shared_places.hpp"

#include <algorithm>

namespace symplant::engine {
namespace {

std::uint32_t place_of(const tables::SymbolRow& symbol) noexcept {
  return symbol.type() == tables::DataType::boolean ? symbol.index : kSharedSlot + symbol.index;
}

}  // namespace

void SharedPlaces::build(const tables::PlantTables& tables, tables::Direction direction, Arena& arena) noexcept {
  std::size_t count = 0;
  for (const tables::SharedAddress& shared : tables.shared_addresses) {
    if (tables.symbols[shared.symbol].direction() == direction) ++count;
  }
  auto* by_place = arena.take<SharedPlace>(2 * count);  // at most as many leaders as followers
  auto* by_leader = arena.take<SharedPlace>(2 * count);
  if (by_place == nullptr || count == 0) return;
  std::size_t size = 0;
  for (const tables::SharedAddress& shared : tables.shared_addresses) {
    const tables::SymbolRow& symbol = tables.symbols[shared.symbol];
    if (symbol.direction() != direction) continue;
    const std::uint32_t leader = place_of(tables.symbols[shared.leader]);
    by_place[size++] = {place_of(symbol), leader};
    by_place[size++] = {leader, leader};
  }
  const auto less_place = [](const SharedPlace& a, const SharedPlace& b) { return a.place < b.place; };
  std::sort(by_place, by_place + size, less_place);
  const auto same = [](const SharedPlace& a, const SharedPlace& b) { return a.place == b.place; };
  size = static_cast<std::size_t>(std::unique(by_place, by_place + size, same) - by_place);
  std::copy(by_place, by_place + size, by_leader);
  std::sort(by_leader, by_leader + size, [](const SharedPlace& a, const SharedPlace& b) {
    return a.leader != b.leader ? a.leader < b.leader : a.place < b.place;
  });
  by_place_ = by_place;
  by_leader_ = by_leader;
  size_ = size;
}

std::span<const SharedPlace> SharedPlaces::with(std::uint32_t place) const noexcept {
  const auto* found = std::lower_bound(by_place_, by_place_ + size_, place,
                                       [](const SharedPlace& a, std::uint32_t b) { return a.place < b; });
  if (found == by_place_ + size_ || found->place != place) return {};
  const auto* first = std::lower_bound(by_leader_, by_leader_ + size_, found->leader,
                                       [](const SharedPlace& a, std::uint32_t b) { return a.leader < b; });
  const auto* last = first;
  while (last != by_leader_ + size_ && last->leader == found->leader) ++last;
  return {first, last};
}

}  // namespace symplant::engine

// Computes which symbols share an address.
#include "symplant/engine/shared_positions.hpp"

#include <algorithm>

namespace symplant::engine {
namespace {

std::uint32_t position_of(const tables::SymbolRow& symbol) noexcept {
  return symbol.type() == tables::DataType::boolean ? symbol.index : kSharedSlot + symbol.index;
}

}  // namespace

void SharedPositions::build(const tables::PlantTables& tables, tables::Direction direction, Arena& arena) noexcept {
  std::size_t count = 0;
  for (const tables::SharedAddress& shared : tables.shared_addresses) {
    if (tables.symbols[shared.symbol].direction() == direction) ++count;
  }
  auto* by_position = arena.take<SharedPosition>(2 * count);  // at most as many leaders as followers
  auto* by_leader = arena.take<SharedPosition>(2 * count);
  if (by_position == nullptr || count == 0) return;
  std::size_t size = 0;
  for (const tables::SharedAddress& shared : tables.shared_addresses) {
    const tables::SymbolRow& symbol = tables.symbols[shared.symbol];
    if (symbol.direction() != direction) continue;
    const std::uint32_t leader = position_of(tables.symbols[shared.leader]);
    by_position[size++] = {position_of(symbol), leader};
    by_position[size++] = {leader, leader};
  }
  const auto less_position = [](const SharedPosition& a, const SharedPosition& b) { return a.position < b.position; };
  std::sort(by_position, by_position + size, less_position);
  const auto same = [](const SharedPosition& a, const SharedPosition& b) { return a.position == b.position; };
  size = static_cast<std::size_t>(std::unique(by_position, by_position + size, same) - by_position);
  std::copy(by_position, by_position + size, by_leader);
  std::sort(by_leader, by_leader + size, [](const SharedPosition& a, const SharedPosition& b) {
    return a.leader != b.leader ? a.leader < b.leader : a.position < b.position;
  });
  by_position_ = by_position;
  by_leader_ = by_leader;
  size_ = size;
}

std::span<const SharedPosition> SharedPositions::with(std::uint32_t position) const noexcept {
  const auto* found = std::lower_bound(by_position_, by_position_ + size_, position,
                                       [](const SharedPosition& a, std::uint32_t b) { return a.position < b; });
  if (found == by_position_ + size_ || found->position != position) return {};
  const auto* first = std::lower_bound(by_leader_, by_leader_ + size_, found->leader,
                                       [](const SharedPosition& a, std::uint32_t b) { return a.leader < b; });
  const auto* last = first;
  while (last != by_leader_ + size_ && last->leader == found->leader) ++last;
  return {first, last};
}

}  // namespace symplant::engine

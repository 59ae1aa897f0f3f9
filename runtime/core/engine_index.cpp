// Works the engine's look-ups out of the tables.
#include "symplant/core/engine_index.hpp"

#include <algorithm>

namespace symplant::core {
namespace {

constexpr std::uint64_t bit(std::uint8_t operation) noexcept { return std::uint64_t{1} << operation; }

void fill_type(const TypeRow& row, std::uint32_t* from_begin, std::uint16_t* from_order, std::uint64_t* starts,
               std::uint64_t* leads, bool* automatic) noexcept {
  for (const Transition& transition : row.transitions) {
    ++from_begin[transition.from + 1];
    if (transition.on == kNoOperation) {
      automatic[transition.from] = true;
    } else {
      starts[transition.from] |= bit(transition.on);
      leads[transition.to] |= bit(transition.on);
    }
  }
  for (std::size_t state = 0; state < row.states; ++state) from_begin[state + 1] += from_begin[state];
  for (std::size_t n = row.transitions.size(); n-- > 0;) {  // from the last: leaves the begins where they were
    const std::uint8_t from = row.transitions[n].from;
    from_order[--from_begin[from + 1]] = static_cast<std::uint16_t>(n);
  }
  // Each begin + 1 now stands where its own state begins: one place too far up.
  for (std::size_t state = 0; state < row.states; ++state) from_begin[state] = from_begin[state + 1];
  from_begin[row.states] = static_cast<std::uint32_t>(row.transitions.size());
  for (std::uint8_t operation = 0; operation < row.operations; ++operation) {
    const std::uint8_t target = row.operation_targets[operation];
    if (target != kNoState) leads[target] |= bit(operation);
  }
}

TypeIndex make_type(const TypeRow& row, Arena& arena) noexcept {
  const std::size_t states = row.states;
  auto* from_begin = arena.take<std::uint32_t>(states + 1);
  auto* from_order = arena.take<std::uint16_t>(row.transitions.size());
  auto* starts = arena.take<std::uint64_t>(states);
  auto* leads = arena.take<std::uint64_t>(states);
  auto* automatic = arena.take<bool>(states);
  if (from_begin != nullptr) fill_type(row, from_begin, from_order, starts, leads, automatic);
  const std::uint64_t all = row.operations == kMaxOperations ? ~std::uint64_t{0} : bit(row.operations) - 1;
  return {row.transitions.data(), from_begin,       from_order, starts,   leads,        automatic,
          row.enter.data(),       row.leave.data(), all,        row.rest, row.actuation};
}

std::uint32_t place_of(const SymbolRow& symbol) noexcept {
  return symbol.type() == DataType::boolean ? symbol.index : kSharedSlot + symbol.index;
}

}  // namespace

void SharedPlaces::build(const PlantTables& tables, Direction direction, Arena& arena) noexcept {
  std::size_t count = 0;
  for (const SharedAddress& shared : tables.shared_addresses) {
    if (tables.symbols[shared.symbol].direction() == direction) ++count;
  }
  auto* by_place = arena.take<SharedPlace>(2 * count);  // at most as many leaders as followers
  auto* by_leader = arena.take<SharedPlace>(2 * count);
  if (by_place == nullptr || count == 0) return;
  std::size_t size = 0;
  for (const SharedAddress& shared : tables.shared_addresses) {
    const SymbolRow& symbol = tables.symbols[shared.symbol];
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

void EngineIndex::build(const PlantTables& tables, Arena& arena) noexcept {
  auto* type_rows = arena.take<TypeIndex>(tables.types.size());
  for (std::size_t i = 0; i < tables.types.size(); ++i) {
    const TypeIndex type = make_type(tables.types[i], arena);
    if (type_rows != nullptr) type_rows[i] = type;
  }
  types = type_rows;
  auto* units = arena.take<std::uint32_t>(tables.operation_bits);
  if (units != nullptr) {
    std::fill(units, units + tables.operation_bits, kNoUnit);
    for (std::uint32_t unit = 0; unit < tables.units.size(); ++unit) {
      const UnitRow& row = tables.units[unit];
      std::fill_n(units + row.operation_bit, tables.types[row.type].operations, unit);
    }
  }
  unit_of_operation = units;
  shared_operations.build(tables, Direction::operation, arena);
  shared_events.build(tables, Direction::event, arena);
}

}  // namespace symplant::core

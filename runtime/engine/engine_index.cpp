// Builds the engine's look-ups from the tables.
#include "symplant/engine/engine_index.hpp"

#include <algorithm>

namespace symplant::engine {
namespace {

constexpr std::uint64_t bit(std::uint8_t operation) noexcept { return std::uint64_t{1} << operation; }

constexpr bool is_operation(std::uint8_t on) noexcept { return on < tables::kMaxOperations; }

struct TypeArrays {
  TypeArrays(const tables::TypeRow& row, Arena& arena) noexcept
      : from_begin(arena.take<std::uint32_t>(row.states + std::size_t{1})),
        from_order(arena.take<std::uint16_t>(row.transitions.size())),
        only_transition(arena.take<std::uint16_t>(row.states)),
        record_of(arena.take<std::uint16_t>(row.transitions.size())),
        automatic(arena.take<bool>(row.states)),
        starts(arena.take<std::uint64_t>(row.states)),
        leads(arena.take<std::uint64_t>(row.states)) {}

  std::uint32_t* from_begin;
  std::uint16_t* from_order;
  std::uint16_t* only_transition;
  std::uint16_t* record_of;
  bool* automatic;
  std::uint64_t* starts;
  std::uint64_t* leads;
};

/// Sorts transition numbers by the state from which they start (a counting sort).
void fill_order(const tables::TypeRow& row, const TypeArrays& arrays) noexcept {
  std::uint32_t* const begin = arrays.from_begin;
  for (const tables::Transition& transition : row.transitions) ++begin[transition.from + 1];
  for (std::size_t state = 0; state < row.states; ++state) begin[state + 1] += begin[state];
  for (std::size_t n = row.transitions.size(); n-- > 0;) {  // from the last, so that each state keeps table order
    arrays.from_order[--begin[row.transitions[n].from + 1]] = static_cast<std::uint16_t>(n);
  }
  // begin[state + 1] now holds the begin of `state`: shift all by one.
  for (std::size_t state = 0; state < row.states; ++state) begin[state] = begin[state + 1];
  begin[row.states] = static_cast<std::uint32_t>(row.transitions.size());
  for (std::size_t state = 0; state < row.states; ++state) {
    const bool one = begin[state + 1] - begin[state] == 1;
    arrays.only_transition[state] = one ? arrays.from_order[begin[state]] : kNoRecord;
  }
}

void fill_masks(const tables::TypeRow& row, const TypeArrays& arrays) noexcept {
  for (const tables::Transition& transition : row.transitions) {
    if (transition.on == tables::kNoOperation) arrays.automatic[transition.from] = true;
    if (!is_operation(transition.on)) continue;
    arrays.starts[transition.from] |= bit(transition.on);
    arrays.leads[transition.to] |= bit(transition.on);
  }
  for (std::uint8_t operation = 0; operation < row.operations; ++operation) {
    const std::uint8_t target = row.operation_targets[operation];
    if (target != tables::kNoState) arrays.leads[target] |= bit(operation);
  }
}

TypeIndex make_type(const tables::TypeRow& row, Arena& arena) noexcept {
  const TypeArrays arrays(row, arena);
  TypeIndex type{};
  type.plain = true;
  for (std::size_t n = 0; n < row.transitions.size(); ++n) {
    const tables::Transition& transition = row.transitions[n];
    if (!is_operation(transition.on) || transition.when != tables::kNoCondition || transition.timed ||
        transition.once) {
      type.plain = false;
    }
    if (arrays.record_of != nullptr) {
      arrays.record_of[n] = transition.timed ? static_cast<std::uint16_t>(type.records) : kNoRecord;
    }
    if (transition.timed) ++type.records;
  }
  if (arrays.from_begin != nullptr) {
    fill_order(row, arrays);
    fill_masks(row, arrays);
  }
  type.transitions = row.transitions.data();
  type.from_begin = arrays.from_begin;
  type.from_order = arrays.from_order;
  type.only_transition = arrays.only_transition;
  type.record_of = arrays.record_of;
  type.automatic = arrays.automatic;
  type.starts = arrays.starts;
  type.leads = arrays.leads;
  type.enter = row.enter.data();
  type.leave = row.leave.data();
  type.times = row.times.data();
  type.travel = row.travel;
  type.operations = row.operations == tables::kMaxOperations ? ~std::uint64_t{0} : bit(row.operations) - 1;
  type.states = row.states;
  type.events = row.events;
  type.rest = row.rest;
  type.actuation = row.actuation;
  return type;
}

std::uint32_t records_of(const tables::TypeRow& row) noexcept {
  return static_cast<std::uint32_t>(std::count_if(row.transitions.begin(), row.transitions.end(),
                                                  [](const tables::Transition& t) { return t.timed; }));
}

}  // namespace

void UnitOfOperation::build(const tables::PlantTables& tables, Arena& arena) noexcept {
  auto* first = arena.take<std::uint32_t>(tables.operation_bits / 64);
  auto* steps = arena.take<std::uint8_t>(tables.operation_bits);
  if (first == nullptr || steps == nullptr) return;
  std::fill(first, first + tables.operation_bits / 64, tables::kNone);
  std::fill(steps, steps + tables.operation_bits, kNoStep);
  for (std::uint32_t unit = 0; unit < tables.units.size(); ++unit) {
    const tables::UnitRow& row = tables.units[unit];
    const std::uint8_t count = tables.types[row.type].operations;
    if (count == 0) continue;
    std::uint32_t& begin = first[row.operation_bit / 64];
    if (begin == tables::kNone) begin = unit;
    std::fill_n(steps + row.operation_bit, count, static_cast<std::uint8_t>(unit - begin));
  }
  first_ = first;
  steps_ = steps;
}

void GeneralUnits::build(const tables::PlantTables& tables, const TypeIndex* types, Arena& arena) noexcept {
  size_ = records_ = 0;
  for (const tables::UnitRow& row : tables.units) {
    if (row.general == 0) continue;
    ++size_;
    records_ += records_of(tables.types[row.type]);
  }
  auto* rows = arena.take<GeneralRow>(size_);
  auto* positions = arena.take<std::uint32_t>(size_ == 0 ? 0 : tables.units.size());
  if (types == nullptr || size_ == 0) return;
  std::uint32_t position = 0;
  for (std::uint32_t unit = 0; unit < tables.units.size(); ++unit) {
    positions[unit] = tables.units[unit].general != 0 ? position++ : tables::kNone;
  }
  rows_ = rows;
  positions_ = positions;
  fill(tables, types, rows);
}

void GeneralUnits::fill(const tables::PlantTables& tables, const TypeIndex* types, GeneralRow* row) noexcept {
  std::uint32_t record = 0;
  std::uint32_t watch = 0;
  std::uint32_t disable = 0;
  std::uint32_t conditioned = 0;
  std::uint32_t behaviour = 0;
  const auto size_of = [](const auto& rows) { return static_cast<std::uint32_t>(rows.size()); };
  for (std::uint32_t unit = 0; unit < tables.units.size(); ++unit) {
    if (tables.units[unit].general == 0) continue;
    *row = {unit, 0, record, watch, watch, disable, disable, tables::kNone};
    record += types[tables.units[unit].type].records;
    while (watch < size_of(tables.unit_watches) && tables.unit_watches[watch].unit == unit) ++watch;
    row->watch_end = watch;
    while (disable < size_of(tables.disables) && tables.disables[disable].by == unit) ++disable;
    row->disable_end = disable;
    if (conditioned < size_of(tables.conditioned_units) && tables.conditioned_units[conditioned].unit == unit) {
      row->first_condition = tables.conditioned_units[conditioned++].first_condition;
    }
    if (behaviour < size_of(tables.behaviour_units) && tables.behaviour_units[behaviour].unit == unit) {
      row->behaviour = behaviour++;
    }
    ++row;
  }
}

void WatchIndex::build(std::span<const tables::BitWatch> watches, std::uint32_t bits, Arena& arena) noexcept {
  if (watches.empty()) return;
  auto* marks = arena.take<std::uint64_t>(bits / 64);
  auto* begins = arena.take<std::uint32_t>(bits / 64 + std::size_t{1});
  if (marks == nullptr || begins == nullptr) return;
  for (const tables::BitWatch& watch : watches) {
    marks[watch.bit / 64] |= std::uint64_t{1} << (watch.bit % 64);
    ++begins[watch.bit / 64 + 1];
  }
  for (std::uint32_t word = 0; word < bits / 64; ++word) begins[word + 1] += begins[word];
  watches_ = watches;
  marks_ = marks;
  begins_ = begins;
}

std::span<const tables::BitWatch> WatchIndex::on(std::uint32_t bit) const noexcept {
  const auto word = watches_.subspan(begins_[bit / 64], begins_[bit / 64 + 1] - begins_[bit / 64]);
  const auto first = std::lower_bound(word.begin(), word.end(), bit,
                                      [](const tables::BitWatch& a, std::uint32_t b) { return a.bit < b; });
  auto last = first;
  while (last != word.end() && last->bit == bit) ++last;
  return {first, last};
}

void ValueReaders::build(const tables::PlantTables& tables, Arena& arena) noexcept {
  auto* readers = arena.take<ValueReader>(tables.behaviour_values.size());
  if (readers == nullptr) return;
  std::size_t size = 0;
  for (const tables::BehaviourUnit& unit : tables.behaviour_units) {
    for (const std::uint32_t value : tables.behaviour_values.subspan(unit.first_value, unit.value_count)) {
      const tables::SymbolRow& symbol = tables.symbols[value];
      readers[size++] = {(symbol.direction() == tables::Direction::operation ? 0 : kSharedSlot) + symbol.index,
                         unit.unit};
    }
  }
  std::sort(readers, readers + size,
            [](const ValueReader& a, const ValueReader& b) { return a.position < b.position; });
  readers_ = {readers, size};
}

std::span<const ValueReader> ValueReaders::of(tables::Direction direction, std::uint32_t slot) const noexcept {
  const std::uint32_t position = (direction == tables::Direction::operation ? 0 : kSharedSlot) + slot;
  const auto first = std::lower_bound(readers_.begin(), readers_.end(), position,
                                      [](const ValueReader& a, std::uint32_t b) { return a.position < b; });
  auto last = first;
  while (last != readers_.end() && last->position == position) ++last;
  return {first, last};
}

void EngineIndex::build(const tables::PlantTables& tables, Arena& arena) noexcept {
  auto* type_rows = arena.take<TypeIndex>(tables.types.size());
  for (std::size_t i = 0; i < tables.types.size(); ++i) {
    const TypeIndex type = make_type(tables.types[i], arena);
    if (type_rows != nullptr) type_rows[i] = type;
  }
  types = type_rows;
  unit_of_operation.build(tables, arena);
  general.build(tables, types, arena);
  operation_watches.build(tables.operation_watches, tables.operation_bits, arena);
  event_watches.build(tables.event_watches, tables.event_bits, arena);
  value_readers.build(tables, arena);
  shared_operations.build(tables, tables::Direction::operation, arena);
  shared_events.build(tables, tables::Direction::event, arena);

  auto* operations = arena.take<std::uint32_t>(tables.operation_bits);
  auto* events = arena.take<std::uint32_t>(tables.event_bits);
  symbol_of_operation = operations;
  symbol_of_event = events;
  if (operations == nullptr || events == nullptr) return;
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
    const tables::SymbolRow& symbol = tables.symbols[i];
    if (symbol.type() != tables::DataType::boolean) continue;
    (symbol.direction() == tables::Direction::operation ? operations : events)[symbol.index] = i;
  }
}

}  // namespace symplant::engine

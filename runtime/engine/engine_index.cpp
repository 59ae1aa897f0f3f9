// Builds the engine's look-ups from the tables.
#include "symplant/engine/engine_index.hpp"

#include <algorithm>

namespace symplant::engine {
namespace {

constexpr std::uint64_t bit(std::uint8_t operation) noexcept { return std::uint64_t{1} << operation; }

constexpr bool is_operation(std::uint8_t on) noexcept { return on < tables::kMaxOperations; }

struct TypeArrays {
  TypeArrays(const tables::TypeRow& row, bool plain, Arena& arena) noexcept
      : at(arena.take<StateIndex>(row.states + std::size_t{1})),
        departures(arena.take<Departure>(plain ? row.states * (row.operations + std::size_t{1}) : 0)),
        from_order(arena.take<std::uint16_t>(row.transitions.size())),
        record_of(arena.take<std::uint16_t>(row.transitions.size())) {}

  StateIndex* at;
  Departure* departures;
  std::uint16_t* from_order;
  std::uint16_t* record_of;
};

/// `overruns`: units of the plant may overrun.
bool is_plain(const tables::TypeRow& row, bool overruns) noexcept {
  return !(overruns && row.actuation == tables::Actuation::held) && row.operations < tables::kMaxOperations &&
         std::all_of(row.transitions.begin(), row.transitions.end(), [](const tables::Transition& t) {
           return t.on != tables::kNoOperation && t.when == tables::kNoCondition && t.during == tables::kNoCondition &&
                  !t.timed && !t.once;
         });
}

/// Sorts transition numbers by the state from which they start (a counting sort).
void fill_order(const tables::TypeRow& row, const TypeArrays& arrays) noexcept {
  StateIndex* const at = arrays.at;
  for (const tables::Transition& transition : row.transitions) ++at[transition.from + 1].from_begin;
  for (std::size_t state = 0; state < row.states; ++state) at[state + 1].from_begin += at[state].from_begin;
  for (std::size_t n = row.transitions.size(); n-- > 0;) {  // from the last, so that each state keeps table order
    arrays.from_order[--at[row.transitions[n].from + 1].from_begin] = static_cast<std::uint16_t>(n);
  }
  // at[state + 1] now holds the begin of `state`: shift all by one.
  for (std::size_t state = 0; state < row.states; ++state) at[state].from_begin = at[state + 1].from_begin;
  at[row.states].from_begin = static_cast<std::uint32_t>(row.transitions.size());
}

void fill_states(const tables::TypeRow& row, const TypeArrays& arrays) noexcept {
  for (std::size_t state = 0; state < row.states; ++state) {
    arrays.at[state].enter = row.enter[state];
    arrays.at[state].leave = row.leave[state];
  }
  for (const tables::Transition& transition : row.transitions) {
    if (transition.on == tables::kNoOperation) arrays.at[transition.from].automatic = true;
    if (!is_operation(transition.on)) continue;
    arrays.at[transition.from].starts |= bit(transition.on);
    arrays.at[transition.to].leads |= bit(transition.on);
  }
  for (std::uint8_t operation = 0; operation < row.operations; ++operation) {
    const std::uint8_t target = row.operation_targets[operation];
    if (target != tables::kNoState) arrays.at[target].leads |= bit(operation);
  }
}

/// The departure from a state if only `on` is on; to kNoState if the unit may have a finding.
Departure departure_of(const tables::TypeRow& row, const TypeArrays& arrays, std::uint8_t state,
                       std::uint64_t on) noexcept {
  constexpr Departure kGeneralPath{kNoTransition, 0, tables::kNoState};
  const StateIndex& at = arrays.at[state];
  const bool returns = on == 0 && row.actuation == tables::Actuation::spring && state != row.rest;
  if ((on & at.starts) == 0 && !returns) {
    return (on & ~at.leads) == 0 ? Departure{kNoTransition, 0, state} : kGeneralPath;
  }
  Departure departure{kNoTransition, row.travel, returns ? row.rest : tables::kNoState};
  bool found = false;
  for (std::uint32_t i = at.from_begin; i < arrays.at[state + 1].from_begin; ++i) {
    const std::uint16_t n = arrays.from_order[i];
    const tables::Transition& transition = row.transitions[n];
    const bool counts = returns ? transition.to == row.rest : is_operation(transition.on) && bit(transition.on) == on;
    if (!counts) continue;
    if (!found) {
      departure = {returns ? kNoTransition : n, transition.dt, transition.to};
      found = true;
    } else if (transition.to != departure.to) {
      return kGeneralPath;
    }
  }
  return departure;
}

void fill_departures(const tables::TypeRow& row, const TypeArrays& arrays) noexcept {
  Departure* departure = arrays.departures;
  for (std::uint8_t state = 0; state < row.states; ++state) {
    arrays.at[state].departures = departure;
    *departure++ = departure_of(row, arrays, state, 0);
    for (std::uint8_t operation = 0; operation < row.operations; ++operation) {
      *departure++ = departure_of(row, arrays, state, bit(operation));
    }
  }
}

TypeIndex make_type(const tables::TypeRow& row, bool overruns, Arena& arena) noexcept {
  TypeIndex type{};
  type.plain = is_plain(row, overruns);
  const TypeArrays arrays(row, type.plain, arena);
  type.stoppable = std::any_of(row.transitions.begin(), row.transitions.end(),
                               [](const tables::Transition& t) { return t.during != tables::kNoCondition; });
  for (std::size_t n = 0; n < row.transitions.size(); ++n) {
    const bool timed = row.transitions[n].timed;
    if (arrays.record_of != nullptr) {
      arrays.record_of[n] = timed ? static_cast<std::uint16_t>(type.records) : kNoRecord;
    }
    if (timed) ++type.records;
  }
  if (arrays.at != nullptr) {
    fill_order(row, arrays);
    fill_states(row, arrays);
    if (type.plain) fill_departures(row, arrays);
  }
  type.at = arrays.at;
  type.transitions = row.transitions.data();
  type.from_order = arrays.from_order;
  type.record_of = arrays.record_of;
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

void OverrunIndex::build(const tables::PlantTables& tables, Arena& arena) noexcept {
  auto* positions = arena.take<std::uint32_t>(tables.overruns.empty() ? 0 : tables.units.size());
  auto* first = arena.take<std::uint32_t>(tables.overruns.size());
  operations_ = 0;
  if (positions != nullptr && !tables.overruns.empty()) std::fill_n(positions, tables.units.size(), tables::kNone);
  for (std::uint32_t row = 0; row < tables.overruns.size(); ++row) {
    const std::uint32_t unit = tables.overruns[row].unit;
    if (positions != nullptr) {
      positions[unit] = row;
      first[row] = operations_;
    }
    operations_ += tables.types[tables.units[unit].type].operations;
  }
  positions_ = tables.overruns.empty() ? nullptr : positions;
  first_operations_ = first;
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
    const TypeIndex type = make_type(tables.types[i], !tables.overruns.empty(), arena);
    if (type_rows != nullptr) type_rows[i] = type;
  }
  types = type_rows;
  unit_of_operation.build(tables, arena);
  general.build(tables, types, arena);
  operation_watches.build(tables.operation_watches, tables.operation_bits, arena);
  event_watches.build(tables.event_watches, tables.event_bits, arena);
  value_readers.build(tables, arena);
  overruns.build(tables, arena);
  shared_operations.build(tables, tables::Direction::operation, arena);
  shared_events.build(tables, tables::Direction::event, arena);

  auto* inverted_bits = arena.take<std::uint64_t>(tables.operation_bits / 64 + std::size_t{1});
  auto* inverted_event_bits = arena.take<std::uint64_t>(tables.event_bits / 64);
  inverted_operations = inverted_bits;
  inverted_events = inverted_event_bits;
  auto* operations = arena.take<std::uint32_t>(tables.operation_bits);
  auto* events = arena.take<std::uint32_t>(tables.event_bits);
  symbol_of_operation = operations;
  symbol_of_event = events;
  if (operations == nullptr || events == nullptr) return;
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
    const tables::SymbolRow& symbol = tables.symbols[i];
    if (symbol.type() != tables::DataType::boolean) continue;
    const bool operation = symbol.direction() == tables::Direction::operation;
    (operation ? operations : events)[symbol.index] = i;
    if (!symbol.inverted()) continue;
    (operation ? inverted_bits : inverted_event_bits)[symbol.index / 64] |= bit(symbol.index % 64);
    some_inverted = true;
  }
}

}  // namespace symplant::engine

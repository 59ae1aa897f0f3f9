// The digest of a plant's tables, field by field (fields.hpp): padding and byte order have no effect on it.
#include "symplant/tables/digest.hpp"

#include <bit>
#include <initializer_list>
#include <type_traits>

#include "symplant/tables/fields.hpp"
#include "symplant/tables/version.hpp"

namespace symplant::tables {
namespace {

/// Adds the fields of a row, each with the width of its type.
struct Add {
  Fnv1a64& hash;

  void operator()(bool value) const noexcept { hash.byte(value ? 1 : 0); }
  void operator()(std::uint8_t value) const noexcept { hash.byte(value); }
  void operator()(std::uint16_t value) const noexcept { hash.u32(value); }
  void operator()(std::uint32_t value) const noexcept { hash.u32(value); }
  void operator()(std::uint64_t value) const noexcept { hash.u64(value); }
  void operator()(double value) const noexcept { hash.u64(std::bit_cast<std::uint64_t>(value)); }
  void operator()(std::int64_t value) const noexcept { hash.u64(static_cast<std::uint64_t>(value)); }
  template <class Number>
  void operator()(Optional<Number> time) const noexcept {
    if (time.value != 0) hash.time(time.value);
  }
  template <class Number>
  void operator()(OptionalIndex<Number> index) const noexcept {
    if (index.value != kNone) hash.u32(index.value);
  }
  template <class Number>
  void operator()(OptionalNumber<Number> number) const noexcept {
    if (number.value != 0) (*this)(number.value);
  }
  template <class Other>
  void operator()(const Other& value) const noexcept {
    if constexpr (std::is_enum_v<Other>) {
      hash.byte(static_cast<std::uint8_t>(value));
    } else if constexpr (Meant<Other>) {
      (*this)(value.value);
    } else {
      fields(value, *this);
    }
  }
};

template <class Row>
void add(Fnv1a64& hash, const Row& row) noexcept {
  Add{hash}(row);
}

void add(Fnv1a64& hash, const TypeRow& type) noexcept {
  hash.byte(type.operations);
  hash.byte(type.events);
  hash.byte(type.states);
  hash.byte(type.rest);
  hash.byte(static_cast<std::uint8_t>(type.actuation));
  hash.u32(static_cast<std::uint32_t>(type.transitions.size()));
  for (const Transition& transition : type.transitions) add(hash, transition);
  for (const EventMasks& masks : type.enter) add(hash, masks);
  for (const EventMasks& masks : type.leave) add(hash, masks);
  for (const std::uint8_t state : type.operation_targets) hash.byte(state);
  hash.u32(static_cast<std::uint32_t>(type.times.size()));
  for (const TransitionTimes& times : type.times) add(hash, times);
  hash.u32(type.travel);
}

void add(Fnv1a64& hash, const UnitRow& unit) noexcept {
  hash.u32(unit.type);
  hash.u32(unit.operation_bit);
  hash.u32(unit.event_bit);
  hash.u32(unit.times);
  hash.byte(unit.initial);
  hash.byte(unit.general);
}

void add(Fnv1a64& hash, const SymbolRow& symbol) noexcept {
  hash.u32(symbol.index);
  hash.u32(symbol.unit);
  hash.u32(symbol.number);
  hash.u32(static_cast<std::uint32_t>(symbol.kind));
}

/// Which symbols belong to which controller: one entry each time that the controller changes. The distribution of a
/// controller's symbols over lists has no effect.
void add_controllers(Fnv1a64& hash, const PlantTables& tables) noexcept {
  std::uint32_t before = 0;
  for (std::size_t i = 0; i < tables.lists.size(); ++i) {
    const SymbolListRow& list = tables.lists[i];
    const std::size_t end = i + 1 < tables.lists.size() ? tables.lists[i + 1].first_symbol : tables.symbols.size();
    if (list.controller == before || list.first_symbol >= end) continue;
    hash.u32(list.first_symbol);
    hash.u32(list.controller);
    before = list.controller;
  }
  hash.u32(kNone);  // end of the list: no symbol has this index
}

/// A table's size is hashed before its rows, so that no row can be read as one of the next table.
template <class Row>
void add_rows(Fnv1a64& hash, std::span<const Row> rows) noexcept {
  hash.u64(rows.size());
  for (const Row& row : rows) add(hash, row);
}

void add_texts(Fnv1a64& hash, std::initializer_list<std::string_view> texts) noexcept {
  for (const std::string_view text : texts) {
    hash.u64(text.size());
    hash.text(text);
  }
}

/// Nothing in a plant without material.
void add_material(Fnv1a64& hash, const PlantTables& tables) noexcept {
  const MaterialTables& material = tables.material;
  if (material.empty()) return;
  add_rows(hash, material.kinds);
  add_rows(hash, material.tracks);
  add_rows(hash, material.drives);
  add_rows(hash, material.stops);
  add_rows(hash, material.ends);
  add_rows(hash, material.sensors);
  add_rows(hash, material.places);
  add_rows(hash, material.transfers);
  add_rows(hash, material.work);
  add_rows(hash, material.sources);
  add_rows(hash, material.sensor_kinds);
  add_rows(hash, material.source_kinds);
  add_rows(hash, material.counters);
  add_rows(hash, tables.part_watches);
  add_texts(hash, {material.kind_names, material.location_names, material.transfer_names, material.work_names,
                   material.source_names});
}

/// Nothing in a plant without written malfunctions.
void add_malfunctions(Fnv1a64& hash, const MalfunctionTables& malfunctions) noexcept {
  if (malfunctions.empty()) return;
  add_rows(hash, malfunctions.rows);
  add_rows(hash, malfunctions.effects);
  add_rows(hash, malfunctions.units);
  add_rows(hash, malfunctions.tracks);
  add_rows(hash, malfunctions.forces);
  add_rows(hash, malfunctions.sets);
  add_texts(hash, {malfunctions.names});
}

/// Nothing in a plant without values, signals and comparisons of two operands.
void add_values(Fnv1a64& hash, const ValueTables& values) noexcept {
  if (values.empty()) return;
  add_rows(hash, values.rows);
  add_rows(hash, values.order);
  add_rows(hash, values.changes);
  add_rows(hash, values.signals);
  add_rows(hash, values.formulas);
  add_rows(hash, values.steps);
  add_rows(hash, values.inputs);
  add_rows(hash, values.numbers);
  add_rows(hash, values.comparisons);
  add_texts(hash, {values.names});
  for (std::size_t f = 0; f < values.compiled.size(); ++f) {
    if (values.compiled[f].replaced) hash.u64(f);
  }
}

}  // namespace

std::uint64_t model_hash(const PlantTables& tables) noexcept {
  Fnv1a64 hash;
  hash.u32(kTablesVersion);
  add_rows(hash, tables.types);
  add_rows(hash, tables.units);
  add_rows(hash, tables.times);
  add_rows(hash, tables.random_times);
  add_rows(hash, tables.symbols);
  add_controllers(hash, tables);
  add_rows(hash, tables.initial_values);
  add_rows(hash, tables.shared_addresses);
  add_rows(hash, tables.disables);
  add_rows(hash, tables.conditions);
  add_rows(hash, tables.conditioned_units);
  add_rows(hash, tables.unit_watches);
  add_rows(hash, tables.operation_watches);
  add_rows(hash, tables.event_watches);
  add_rows(hash, tables.operation_value_watches);
  add_rows(hash, tables.event_value_watches);
  add_rows(hash, tables.requirements);
  add_rows(hash, tables.follows);
  add_rows(hash, tables.overruns);
  add_rows(hash, tables.behaviour_units);
  add_rows(hash, tables.behaviour_values);
  for (const std::uint32_t size :
       {tables.operation_bits, tables.event_bits, tables.operation_slots, tables.event_slots}) {
    hash.u32(size);
  }
  add_texts(hash, {tables.name, tables.unit_names, tables.state_names, tables.symbol_names, tables.requirement_names,
                   tables.behaviour_names, tables.controller_names});
  add_material(hash, tables);
  add_malfunctions(hash, tables.malfunctions);
  add_values(hash, tables.values);
  return hash.value();
}

}  // namespace symplant::tables

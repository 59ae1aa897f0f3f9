// The digest of a plant's tables, field by field: padding and byte order have no effect on it.
#include "symplant/tables/digest.hpp"

#include <initializer_list>

#include "symplant/tables/version.hpp"

namespace symplant::tables {
namespace {

template <class Enumeration>
void add_enumerator(Fnv1a64& hash, Enumeration value) noexcept {
  hash.byte(static_cast<std::uint8_t>(value));
}

void add(Fnv1a64& hash, const Transition& transition) noexcept {
  hash.byte(transition.from);
  hash.byte(transition.to);
  hash.byte(transition.on);
  hash.byte(transition.once ? 1 : 0);
  hash.u32(transition.when);
  hash.byte(transition.timed ? 1 : 0);
  hash.u32(transition.dt);
  hash.u32(transition.during);
  hash.u32(transition.weight);
}

void add(Fnv1a64& hash, const EventMasks& masks) noexcept {
  hash.u64(masks.on);
  hash.u64(masks.off);
}

void add(Fnv1a64& hash, const TransitionTimes& times) noexcept {
  hash.time(times.after);
  hash.time(times.takes);
}

void add(Fnv1a64& hash, const TypeRow& type) noexcept {
  hash.byte(type.operations);
  hash.byte(type.events);
  hash.byte(type.states);
  hash.byte(type.rest);
  add_enumerator(hash, type.actuation);
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

void add(Fnv1a64& hash, const RandomTime& random) noexcept {
  add_enumerator(hash, random.kind);
  hash.time(random.a);
  hash.time(random.b);
}

void add(Fnv1a64& hash, const SymbolRow& symbol) noexcept {
  hash.u32(symbol.index);
  hash.u32(symbol.unit);
  hash.u32(symbol.number);
  hash.u32(static_cast<std::uint32_t>(symbol.kind));
}

void add(Fnv1a64& hash, const InitialValue& initial) noexcept {
  hash.u32(initial.symbol);
  hash.u64(initial.value);
}

void add(Fnv1a64& hash, const SharedAddress& shared) noexcept {
  hash.u32(shared.symbol);
  hash.u32(shared.leader);
}

void add(Fnv1a64& hash, const DisableRow& row) noexcept {
  hash.u32(row.by);
  hash.u32(row.unit);
  hash.byte(row.state);
}

void add(Fnv1a64& hash, const ConditionRow& condition) noexcept {
  hash.u64(condition.truth);
  hash.u32(condition.reader);
  hash.byte(condition.reader_input);
  add_enumerator(hash, condition.reader_kind);
}

void add(Fnv1a64& hash, const ConditionedUnit& row) noexcept {
  hash.u32(row.unit);
  hash.u32(row.first_condition);
}

void add(Fnv1a64& hash, const UnitWatch& watch) noexcept {
  hash.u32(watch.unit);
  hash.u32(watch.condition);
  hash.byte(watch.state);
  hash.byte(watch.input);
}

void add(Fnv1a64& hash, const BitWatch& watch) noexcept {
  hash.u32(watch.bit);
  hash.u32(watch.condition);
  hash.byte(watch.input);
}

void add(Fnv1a64& hash, const ValueWatch& watch) noexcept {
  hash.u64(watch.operand);
  hash.u32(watch.slot);
  hash.u32(watch.condition);
  hash.byte(watch.input);
  add_enumerator(hash, watch.comparison);
  add_enumerator(hash, watch.kind);
}

void add(Fnv1a64& hash, const RequirementRow& requirement) noexcept {
  add_enumerator(hash, requirement.kind);
  hash.u32(requirement.condition);
  hash.u32(requirement.expected);
  hash.time(requirement.within);
  if (requirement.earliest != 0) hash.time(requirement.earliest);
}

void add(Fnv1a64& hash, const FollowRow& row) noexcept {
  hash.u32(row.symbol);
  hash.u32(row.condition);
}

void add(Fnv1a64& hash, const OverrunRow& row) noexcept {
  hash.u32(row.unit);
  hash.time(row.after);
}

void add(Fnv1a64& hash, const Rows& rows) noexcept {
  hash.u32(rows.first);
  hash.u32(rows.count);
}

void add(Fnv1a64& hash, const PartLocation& location) noexcept {
  hash.u32(location.location);
  hash.u64(static_cast<std::uint64_t>(location.at));
}

void add_length(Fnv1a64& hash, std::int64_t length) noexcept { hash.u64(static_cast<std::uint64_t>(length)); }

void add(Fnv1a64& hash, const KindRow& row) noexcept {
  add_length(hash, row.length);
  hash.u32(row.code);
}

void add(Fnv1a64& hash, const TrackRow& row) noexcept {
  add_length(hash, row.length);
  add_length(hash, row.gap);
  for (const Rows& rows : {row.drives, row.stops, row.sensors, row.ends}) add(hash, rows);
}

void add(Fnv1a64& hash, const DriveRow& row) noexcept {
  add_length(hash, row.until);
  hash.u32(row.forward);
  hash.u32(row.backward);
  hash.u32(row.symbol);
  add_length(hash, row.speed);
}

void add(Fnv1a64& hash, const StopRow& row) noexcept {
  add_length(hash, row.at);
  hash.u32(row.condition);
}

void add(Fnv1a64& hash, const EndRow& row) noexcept {
  hash.u32(row.to);
  hash.u32(row.condition);
}

void add(Fnv1a64& hash, const SensorRow& row) noexcept {
  hash.u32(row.symbol);
  hash.u32(row.location);
  add_length(hash, row.at);
  add(hash, row.kinds);
  add_enumerator(hash, row.reads);
}

void add(Fnv1a64& hash, const PlaceRow& row) noexcept {
  hash.u32(row.holds);
  add(hash, row.sensors);
}

void add(Fnv1a64& hash, const TransferRow& row) noexcept {
  add(hash, row.from);
  add(hash, row.to);
  hash.u32(row.condition);
  hash.byte(row.once ? 1 : 0);
}

void add(Fnv1a64& hash, const WorkRow& row) noexcept {
  add(hash, row.at);
  hash.u32(row.condition);
  hash.u32(row.from);
  hash.u32(row.to);
}

void add(Fnv1a64& hash, const SourceRow& row) noexcept {
  add(hash, row.to);
  add(hash, row.kinds);
  hash.time(row.first);
  hash.time(row.every);
  hash.u64(row.count);
  hash.u32(row.condition);
}

void add(Fnv1a64& hash, const PartCounterRow& row) noexcept {
  hash.u32(row.location);
  hash.u32(row.kind);
}

void add(Fnv1a64& hash, const MalfunctionRow& row) noexcept {
  add_enumerator(hash, row.kind);
  add(hash, row.of);
  hash.u32(row.factor);
  hash.u32(row.subject);
  for (const Time time : {row.every, row.shows, row.chance, row.lasts, row.after}) hash.time(time);
  for (const std::uint32_t index : {row.condition, row.unless, row.next}) hash.u32(index);
}

void add(Fnv1a64& hash, const MalfunctionUnit& row) noexcept {
  hash.u32(row.unit);
  hash.byte(row.state);
}

void add(Fnv1a64& hash, const MalfunctionForce& row) noexcept {
  hash.u32(row.symbol);
  hash.u64(row.value);
}

void add(Fnv1a64& hash, const BehaviourUnit& row) noexcept {
  hash.u32(row.unit);
  hash.u32(row.name);
  hash.u32(row.first_input);
  hash.u32(row.input_count);
  hash.u32(row.first_value);
  hash.u32(row.value_count);
}

void add(Fnv1a64& hash, std::uint32_t value) noexcept { hash.u32(value); }

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
  add_rows(hash, malfunctions.units);
  add_rows(hash, malfunctions.forces);
  add_texts(hash, {malfunctions.names});
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
  return hash.value();
}

}  // namespace symplant::tables

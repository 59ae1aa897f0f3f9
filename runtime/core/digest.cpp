// The digest of a plant's tables, field by field so that neither padding nor byte order counts.
#include "symplant/core/digest.hpp"

#include "symplant/core/version.hpp"

namespace symplant::core {
namespace {

void add_type(Fnv1a64& hash, const TypeRow& type) noexcept {
  hash.byte(type.operations);
  hash.byte(type.events);
  hash.byte(type.states);
  hash.byte(type.rest);
  hash.byte(static_cast<std::uint8_t>(type.actuation));
  hash.u32(static_cast<std::uint32_t>(type.transitions.size()));
  for (const Transition& transition : type.transitions) {
    hash.byte(transition.from);
    hash.byte(transition.to);
    hash.byte(transition.on);
  }
  for (const std::uint64_t events : type.enter) hash.u64(events);
  for (const std::uint64_t events : type.leave) hash.u64(events);
  for (const std::uint8_t state : type.operation_targets) hash.byte(state);
}

void add_unit(Fnv1a64& hash, const UnitRow& unit) noexcept {
  hash.u32(unit.type);
  hash.u32(unit.operation_bit);
  hash.u32(unit.event_bit);
  hash.u32(unit.times);
  hash.byte(unit.initial);
}

void add_symbol(Fnv1a64& hash, const SymbolRow& symbol) noexcept {
  hash.u32(symbol.index);
  hash.u32(symbol.unit);
  hash.u32(symbol.number);
  hash.u32(static_cast<std::uint32_t>(symbol.kind));
}

}  // namespace

std::uint64_t model_hash(const PlantTables& tables) noexcept {
  Fnv1a64 hash;
  hash.u32(kTablesVersion);
  for (const std::size_t size : {tables.name.size(), tables.types.size(), tables.units.size(), tables.times.size(),
                                 tables.symbols.size(), tables.initial_values.size(), tables.shared_addresses.size()}) {
    hash.u64(size);
  }
  for (const TypeRow& type : tables.types) add_type(hash, type);
  for (const UnitRow& unit : tables.units) add_unit(hash, unit);
  for (const TransitionTimes& times : tables.times) {
    hash.u64(static_cast<std::uint64_t>(times.after));
    hash.u64(static_cast<std::uint64_t>(times.takes));
  }
  for (const SymbolRow& symbol : tables.symbols) add_symbol(hash, symbol);
  for (const InitialValue& initial : tables.initial_values) {
    hash.u32(initial.symbol);
    hash.u64(initial.value);
  }
  for (const SharedAddress& shared : tables.shared_addresses) {
    hash.u32(shared.symbol);
    hash.u32(shared.leader);
  }
  for (const std::uint32_t size :
       {tables.operation_bits, tables.event_bits, tables.operation_slots, tables.event_slots}) {
    hash.u32(size);
  }
  for (const std::string_view text : {tables.name, tables.unit_names, tables.state_names, tables.symbol_names}) {
    hash.u64(text.size());
    hash.text(text);
  }
  return hash.value();
}

}  // namespace symplant::core

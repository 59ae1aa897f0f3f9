// The fields of the digest, in their order.
#include "support/reference/hash.hpp"

#include <bit>

#include "support/reference/material.hpp"
#include "support/reference/round.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::reference {
namespace {

struct Digest : tables::Fnv1a64 {
  void flag(bool value) { byte(value ? 1 : 0); }
  void u16(std::uint16_t value) {
    byte(static_cast<std::uint8_t>(value & 0xFF));
    byte(static_cast<std::uint8_t>(value >> 8));
  }
  void real(double value) { u64(std::bit_cast<std::uint64_t>(value)); }
  void i64(std::int64_t value) { u64(static_cast<std::uint64_t>(value)); }
};

std::uint8_t force_of(const SymbolWorld& symbol) {
  if (!symbol.forced) return 0;
  return symbol.forced_value != 0 ? 2 : 1;
}

/// The bit; of an operation as last written, sampled or not.
std::uint64_t bit_of(const Rules& rules, const World& world, std::uint32_t symbol) {
  return rules.is_operation(symbol) ? world.symbols[symbol].written : world.symbols[symbol].value;
}

void add_operations(Digest& digest, const Rules& rules, const World& world, std::uint32_t index) {
  const UnitRules& unit = rules.units[index];
  for (std::uint32_t i = 0; i < unit.operations.size(); ++i) {
    const std::uint32_t symbol = unit.operations[i];
    const OperationWorld& its = world.units[index].operations[i];
    const bool on = is_on(rules, world, symbol);
    digest.flag(rules.turned(symbol, bit_of(rules, world, symbol)) != 0);
    digest.flag(!on || its.armed || unit.actuation != tables::Actuation::latched);
    digest.byte(force_of(world.symbols[symbol]));
    // Both keep the command from being lost, and the digest has one flag for them.
    digest.flag(on && (its.served || its.reached));
    digest.flag(on && its.had_finding);
  }
}

void add_unit(Digest& digest, const Rules& rules, const World& world, std::uint32_t index) {
  const UnitRules& unit = rules.units[index];
  const UnitWorld& its = world.units[index];
  digest.byte(its.state);
  digest.byte(its.target);
  digest.u16(its.moving_now);
  digest.i64(its.remaining);
  digest.i64(its.whole);
  digest.byte(static_cast<std::uint8_t>((its.moving ? 1 : 0) | (its.disabled ? 2 : 0) | (its.frozen ? 4 : 0)));
  for (const TransitionWorld& transition : its.transitions) {
    digest.flag(transition.holds);
    digest.i64(transition.left);
    digest.u32(transition.draws);
  }
  add_operations(digest, rules, world, index);
  for (const std::uint32_t symbol : unit.events) {
    digest.flag(rules.turned(symbol, world.symbols[symbol].value) != 0);
    digest.byte(force_of(world.symbols[symbol]));
  }
  if (unit.behaviour == nullptr) return;
  digest.u32(its.own_draws);
  digest.i64(its.until_woken);
  for (std::uint32_t i = 0; i < unit.behaviour->memory_size; ++i) {
    digest.byte(static_cast<std::uint8_t>(its.memory[i / 8] >> (8 * (i % 8))));
  }
}

void add_free_symbol(Digest& digest, const Rules& rules, const World& world, std::uint32_t index) {
  const SymbolWorld& symbol = world.symbols[index];
  if (rules.is_bool(index)) {
    digest.flag(bit_of(rules, world, index) != 0);
    digest.byte(force_of(symbol));
    return;
  }
  digest.u64(bit_of(rules, world, index));
  digest.flag(symbol.forced);
  digest.u64(symbol.forced ? symbol.forced_value : 0);
}

void add_track(Digest& digest, const Rules& rules, const World& world, std::uint32_t index) {
  const TrackWorld& track = world.material.tracks[index];
  digest.u32(static_cast<std::uint32_t>(track.parts.size()));
  for (const PartWorld& part : track.parts) {
    digest.u64(part.number);
    digest.u32(part.kind);
    digest.i64(part.x0);
    digest.i64(part.t0);
    digest.i64(part.v);
  }
  for (const TailWorld& tail : world.material.tails) {
    if (tail.to != index || across(rules, world.material, tail, world.time) == nullptr) continue;
    digest.byte(track.frozen ? 3 : 2);
    digest.u32(tail.on);
    digest.i64(tail.left);
    return;  // there is at most one
  }
  digest.flag(track.frozen);
}

void add_place(Digest& digest, const std::vector<PartWorld>& parts) {
  digest.u32(static_cast<std::uint32_t>(parts.size()));
  for (const PartWorld& part : parts) {
    digest.u64(part.number);
    digest.u32(part.kind);
  }
}

void add_material(Digest& digest, const Rules& rules, const World& world) {
  const MaterialWorld& material = world.material;
  if (material.tracks.empty() && material.places.empty()) return;
  for (std::uint32_t i = 0; i < material.tracks.size(); ++i) add_track(digest, rules, world, i);
  for (const std::vector<PartWorld>& parts : material.places) add_place(digest, parts);
  for (const TransferWorld& transfer : material.transfers) {
    digest.byte(static_cast<std::uint8_t>((transfer.permission ? 1 : 0) | (transfer.moved ? 2 : 0) |
                                          (transfer.frozen ? 4 : 0)));
  }
  for (const WorkWorld& work : material.work) {
    digest.byte(static_cast<std::uint8_t>((work.truth ? 1 : 0) | (work.frozen ? 2 : 0)));
  }
  for (const SourceWorld& source : material.sources) {
    digest.i64(source.due);
    digest.u64(source.made);
    digest.u32(source.draws);
    digest.flag(source.frozen);
  }
  digest.u64(material.next_number);
}

void add_effects(Digest& digest, const model::Malfunction& malfunction, const MalfunctionWorld& its) {
  for (std::size_t e = 0; e < its.effects.size(); ++e) {
    const model::Effect& effect = malfunction.effects[e];
    if (effect.kind == tables::MalfunctionKind::flicker) {
      digest.flag(its.effects[e].shows_opposite);
      digest.i64(its.effects[e].flickers);
      digest.u32(its.effects[e].draws);
    }
    for (std::size_t f = 0; f < effect.forces.size(); ++f) {
      if (effect.forces[f].holds) digest.u64(e < its.begun ? its.effects[e].held[f] : 0);
    }
  }
}

void add_malfunctions(Digest& digest, const model::PlantModel& model, const MalfunctionsWorld& malfunctions) {
  for (std::size_t i = 0; i < malfunctions.written.size(); ++i) {
    const MalfunctionWorld& its = malfunctions.written[i];
    digest.byte(static_cast<std::uint8_t>((its.active ? 1 : 0) | (its.truth ? 2 : 0) | (its.frozen ? 4 : 0) |
                                          (its.stopped ? 8 : 0)));
    digest.i64(its.since);
    digest.i64(its.next_due());
    for (const std::uint32_t draws : its.draws) digest.u32(draws);
    add_effects(digest, model.malfunctions[i], its);
  }
  for (const ActiveWorld& one : malfunctions.active) {
    digest.u32(one.number);
    digest.i64(one.since);
  }
}

/// The inputs of the last computation: a flag whether they were stored, then each of them, 0 if not. Only of values
/// that make steps from them; those of `delay` are in its memory.
void add_stored(Digest& digest, const ValueRules& rules, const ValueWorld& value) {
  if (!rules.steps()) return;
  digest.flag(value.stored);
  if (rules.kind == tables::ValueKind::delay) return;
  for (std::size_t i = 0; i < rules.inputs.size(); ++i) digest.real(value.stored ? value.inputs[i] : 0);
}

void add_last(Digest& digest, const ValueWorld& value) {
  digest.flag(value.last.has_value());
  digest.real(value.last.value_or(0));
}

/// `delay`: the stored inputs from the oldest to the newest; `linear`: the states; a parameter that a malfunction
/// holds: the number without it; `derivative`: a flag whether there is a last u, and it; `pid`: i, a flag whether there
/// is a last `of`, and it. What there is not is 0.
void add_memory(Digest& digest, const ValueRules& rules, const ValueWorld& value) {
  for (const double each : value.ring) digest.real(each);
  for (const double each : value.states) digest.real(each);
  if (value.without_malfunctions) digest.real(*value.without_malfunctions);
  if (rules.kind == tables::ValueKind::pid) digest.real(value.integral);
  if (rules.kind == tables::ValueKind::pid || rules.kind == tables::ValueKind::derivative) add_last(digest, value);
}

/// For each value in the order of the file: outputs, stored inputs, memory, frozen flag (1 byte), draws (u32). For each
/// signal in list order: draws (u32). For each entry of `changes`, value by value: its last truth (1 byte). Doubles are
/// their 64 bits. Nothing of a plant without values and signals.
void add_values(Digest& digest, const Rules& rules, const World& world) {
  for (std::size_t i = 0; i < world.values.size(); ++i) {
    const ValueWorld& value = world.values[i];
    for (const double output : value.outputs) digest.real(output);
    add_stored(digest, rules.values[i], value);
    add_memory(digest, rules.values[i], value);
    digest.flag(value.frozen);
    digest.u32(value.draws);
  }
  for (const SignalWorld& signal : world.signals) digest.u32(signal.draws);
  for (const ValueWorld& value : world.values) {
    for (const bool truth : value.truths) digest.flag(truth);
  }
}

}  // namespace

std::uint64_t state_hash(const Rules& rules, const World& world) {
  Digest digest;
  digest.i64(world.time);
  for (std::uint32_t i = 0; i < world.units.size(); ++i) add_unit(digest, rules, world, i);
  for (std::uint32_t i = 0; i < world.symbols.size(); ++i) {
    if (rules.model->symbols[i].unit == model::kNone) add_free_symbol(digest, rules, world, i);
  }
  for (const MonitorWorld& monitor : world.monitors) {
    digest.flag(monitor.running);
    digest.i64(monitor.deadline);
    digest.flag(monitor.truth);
  }
  add_material(digest, rules, world);
  add_malfunctions(digest, *rules.model, world.malfunctions);
  add_values(digest, rules, world);
  for (std::uint32_t i = 0; i < world.units.size(); ++i) {
    if (!world.units[i].conflicting) continue;
    digest.byte(0);
    digest.u32(i);
  }
  for (std::uint32_t i = 0; i < world.units.size(); ++i) {
    if (!world.units[i].stopped) continue;
    digest.byte(1);
    digest.u32(i);
  }
  for (std::uint32_t i = 0; i < world.units.size(); ++i) {
    if (!world.units[i].overrun) continue;
    digest.byte(2);
    digest.u32(i);
  }
  for (std::uint32_t i = 0; i < world.material.transfers.size(); ++i) {
    if (!world.material.transfers[i].blocked) continue;
    digest.byte(3);
    digest.u32(i);
  }
  for (std::uint32_t i = 0; i < world.values.size(); ++i) {
    if (!world.values[i].not_finite) continue;
    digest.byte(4);
    digest.u32(i);
  }
  return digest.value();
}

}  // namespace symplant::reference

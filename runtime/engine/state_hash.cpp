// The digest of the logical state, in the fields and order of docs/engine.md.
#include <algorithm>

#include "symplant/engine/engine_inline.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::engine {
namespace {

std::uint8_t digit_of(std::uint64_t word, std::uint32_t bit) noexcept {
  return static_cast<std::uint8_t>((word >> (bit % 64)) & 1);
}

std::uint8_t digit_of(const std::uint64_t* plane, std::uint32_t bit) noexcept { return digit_of(plane[bit / 64], bit); }

/// In bits: 1 is forced off, 2 forced on. `inverted`: masks over the plane.
std::uint8_t force_of(const BitPlane& plane, const std::uint64_t* inverted, std::uint32_t bit) noexcept {
  if (!plane.is_forced(bit)) return 0;
  return static_cast<std::uint8_t>(1 + (digit_of(plane.forced_on, bit) ^ digit_of(inverted, bit)));
}

}  // namespace

void Engine::hash_move(tables::Fnv1a64& hash, std::uint32_t unit) const noexcept {
  const UnitState& state = units_[unit];
  const bool moving = (state.flags & kMoving) != 0;
  hash.byte(state.state);
  hash.byte(moving ? state.target : state.state);
  hash.byte(static_cast<std::uint8_t>(state.transition));
  hash.byte(static_cast<std::uint8_t>(state.transition >> 8));
  hash.time(moving ? remaining(unit) : 0);
  hash.time(whole(unit));
  const bool disabled = (state.flags & kDisabled) != 0;
  const bool frozen = (state.flags & kFrozen) != 0;
  hash.byte(static_cast<std::uint8_t>((moving ? 1 : 0) | (disabled ? 2 : 0) | (frozen ? 4 : 0)));
}

void Engine::hash_transitions(tables::Fnv1a64& hash, std::uint32_t unit) const noexcept {
  const tables::UnitRow& row = tables_.units[unit];
  const TypeIndex& type = index_.types[row.type];
  const UnitState& state = units_[unit];
  const bool halted = (state.flags & kHalted) != 0;
  const bool holding = state.holding != 0;
  const GeneralRow* general = row.general != 0 ? &general_row(unit) : nullptr;
  const Behaviour* behaviour = general != nullptr ? behaviour_of(*general) : nullptr;
  const std::uint32_t first_record = general != nullptr ? general->first_record : 0;
  const bool by_behaviour = behaviour != nullptr && behaviour->after != nullptr;
  for (std::size_t n = 0; n < tables_.types[row.type].transitions.size(); ++n) {
    Record record{};
    if (type.record_of[n] != kNoRecord) record = records_[first_record + type.record_of[n]];
    const bool remembers = by_behaviour || times_of(row, type, type.transitions[n].dt).after != 0;
    const bool held = remembers && holding && type.transitions[n].from == state.state && record.holds != 0;
    hash.byte(held ? 1 : 0);
    const bool counted_down = !halted && record.ready != tables::kNever;
    hash.time(!held ? 0 : counted_down ? std::max<tables::Time>(0, record.ready - head_->now) : record.ready);
    hash.u32(record.draws);
  }
}

void Engine::hash_symbols(tables::Fnv1a64& hash, std::uint32_t unit) const noexcept {
  const tables::UnitRow& row = tables_.units[unit];
  const tables::TypeRow& type = tables_.types[row.type];
  for (std::uint32_t bit = row.operation_bit; bit < row.operation_bit + type.operations; ++bit) {
    const OperationWord& word = operation_words_[bit / 64];
    hash.byte(digit_of(word.written ^ index_.inverted_operations[bit / 64], bit));
    hash.byte(static_cast<std::uint8_t>(1 - digit_of(disarmed_, bit)));
    hash.byte(force_of(operations_, index_.inverted_operations, bit));
    hash.byte(digit_of(word.served, bit));
    hash.byte(digit_of(word.reported, bit));
  }
  for (std::uint32_t bit = row.event_bit; bit < row.event_bit + type.events; ++bit) {
    hash.byte(digit_of(events_.made(bit / 64), bit));
    hash.byte(force_of(events_, index_.inverted_events, bit));
  }
}

void Engine::hash_behaviour(tables::Fnv1a64& hash, std::uint32_t unit) const noexcept {
  if (tables_.units[unit].general == 0) return;
  const GeneralRow& general = general_row(unit);
  if (behaviour_of(general) == nullptr) return;
  const BehaviourState& state = behaviour_states_[general.behaviour];
  const bool halted = (units_[unit].flags & kHalted) != 0;
  hash.u32(state.draws);
  tables::Time left = -1;
  if (state.wake != tables::kNever) left = halted ? state.wake : state.wake - head_->now;
  hash.time(state.woken != 0 ? 0 : left);
  const auto* memory = reinterpret_cast<const std::uint8_t*>(behaviour_memory_);
  for (std::uint32_t i = 0; i < memory_of(general.behaviour); ++i)
    hash.byte(memory[memory_begins_[general.behaviour] + i]);
}

void Engine::hash_free_symbol(tables::Fnv1a64& hash, const tables::SymbolRow& symbol) const noexcept {
  const bool operation = symbol.direction() == tables::Direction::operation;
  if (symbol.type() == tables::DataType::boolean) {
    const BitPlane& plane = operation ? operations_ : events_;
    const std::uint32_t word = symbol.index / 64;
    const std::uint64_t* const inverted = operation ? index_.inverted_operations : index_.inverted_events;
    const std::uint64_t bits = operation ? operation_words_[word].written : plane.made(word) ^ inverted[word];
    hash.byte(digit_of(bits, symbol.index));
    hash.byte(force_of(plane, inverted, symbol.index));
    return;
  }
  const ValuePlane& plane = operation ? operation_values_ : event_values_;
  hash.u64(operation ? written_values_[symbol.index] : plane.made[symbol.index]);
  const bool forced = plane.is_forced(symbol.index);
  hash.byte(forced ? 1 : 0);
  hash.u64(forced ? plane.forced_to[symbol.index] : 0);
}

std::uint64_t Engine::state_hash() const noexcept {
  tables::Fnv1a64 hash;
  const auto unit_count = static_cast<std::uint32_t>(tables_.units.size());
  hash.time(head_->now);
  for (std::uint32_t unit = 0; unit < unit_count; ++unit) {
    hash_move(hash, unit);
    hash_transitions(hash, unit);
    hash_symbols(hash, unit);
    hash_behaviour(hash, unit);
  }
  for (const tables::SymbolRow& symbol : tables_.symbols) {
    if (symbol.unit == tables::kNone) hash_free_symbol(hash, symbol);
  }
  for (std::size_t r = 0; r < tables_.requirements.size(); ++r) {
    hash.byte(monitors_[r].running != 0 ? 1 : 0);
    hash.time(monitors_[r].running != 0 ? later(monitors_[r].started, tables_.requirements[r].within) : 0);
    hash.byte(monitors_[r].held != 0 ? 1 : 0);
  }
  flow_.hash(hash);
  malfunctions_.hash(hash);
  values_.hash(hash);
  for (std::uint8_t kind = 0; kind < 2; ++kind) {
    for (std::uint32_t unit = 0; unit < unit_count; ++unit) {
      if ((units_[unit].flags & (kind == 0 ? kConflictReported : kStoppedReported)) == 0) continue;
      hash.byte(kind);
      hash.u32(unit);
    }
  }
  for (std::size_t position = 0; position < tables_.overruns.size(); ++position) {
    if (overrun_states_[position].found == 0) continue;
    hash.byte(2);
    hash.u32(tables_.overruns[position].unit);
  }
  flow_.hash_blocked(hash);
  values_.hash_not_finite(hash);
  return hash.value();
}

}  // namespace symplant::engine

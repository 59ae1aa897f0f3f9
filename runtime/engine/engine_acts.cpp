// Actions on a plant from outside: writes of the PLC, inputs, forces, manual state changes, restored states.
#include <algorithm>
#include <bit>
#include <cstring>

#include "symplant/engine/engine_inline.hpp"

namespace symplant::engine {
namespace {

bool is_bit(const tables::SymbolRow& symbol) noexcept { return symbol.type() == tables::DataType::boolean; }

/// Calls `function(position)` for a bit or slot and for all others with the same address.
template <class Function>
void for_address(const SharedPositions& shared, bool bit, std::uint32_t position, Function function) noexcept {
  const std::uint32_t base = bit ? 0 : kSharedSlot;
  const auto others = shared.empty() ? std::span<const SharedPosition>() : shared.with(base + position);
  if (others.empty()) function(position);
  for (const SharedPosition& other : others) function(other.position - base);
}

bool has_bit(const std::uint64_t* plane, std::uint32_t bit) noexcept {
  return (plane[bit / 64] & bit_in_word(bit)) != 0;
}

}  // namespace

/// Called after a word of operations is written.
inline void Engine::wait_for_sample(std::uint32_t word) noexcept {
  if (operation_words_[word].waiting != 0) return;
  operation_words_[word].waiting = 1;
  written_words_.add(word);
}

void Engine::write_operation(std::uint32_t bit, bool on) noexcept {
  const std::uint32_t word = bit / 64;
  set_bit(operation_words_[word].written, bit, on);
  wait_for_sample(word);
  if (!index_.shared_operations.empty()) write_shared(bit, on);
}

void Engine::write_operations(std::uint32_t word, std::uint64_t mask, std::uint64_t bits) noexcept {
  std::uint64_t& written = operation_words_[word].written;
  written = (written & ~mask) | (bits & mask);
  wait_for_sample(word);
  if (!index_.shared_operations.empty()) [[unlikely]]
    write_shared(word, mask, bits);
}

void Engine::write_shared(std::uint32_t word, std::uint64_t mask, std::uint64_t bits) noexcept {
  for (; mask != 0; mask &= mask - 1) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(mask));
    write_shared(word * 64 + bit, (bits >> bit & 1) != 0);
  }
}

void Engine::write_shared(std::uint32_t bit, bool on) noexcept {
  for (const SharedPosition& other : index_.shared_operations.with(bit)) {
    set_bit(operation_words_[other.position / 64].written, other.position, on);
    wait_for_sample(other.position / 64);
  }
}

void Engine::write_operation_value(std::uint32_t slot, std::uint64_t value) noexcept {
  for_address(index_.shared_operations, false, slot, [&](std::uint32_t position) {
    written_values_[position] = value;
    written_slots_.mark(position);
  });
}

bool Engine::set_input(std::uint32_t symbol, std::uint64_t value) noexcept {
  const tables::SymbolRow& row = tables_.symbols[symbol];
  if (row.direction() == tables::Direction::operation) return false;
  const SharedPositions& shared = index_.shared_events;
  bool moved = row.moved();
  if (!shared.empty() && is_bit(row)) {
    for (const SharedPosition& other : shared.with(row.index)) {
      moved = moved || tables_.symbols[index_.symbol_of_event[other.position]].moved();
    }
  }
  if (moved) return false;
  if (is_bit(row)) {
    unpublished_ = true;
    for_address(shared, true, row.index, [&](std::uint32_t bit) {
      const bool on = (value != 0) != has_bit(index_.inverted_events, bit);
      events_.make(bit / 64, with_bit(events_.made(bit / 64), bit, on));
    });
  } else {
    make_event_value(row.index, value);
    for_address(shared, false, row.index, [&](std::uint32_t slot) { touch_readers(tables::Direction::event, slot); });
  }
  head_->waits |= kActed;
  return true;
}

bool Engine::is_forced(std::uint32_t symbol) const noexcept {
  const tables::SymbolRow& row = tables_.symbols[symbol];
  const bool operation = row.direction() == tables::Direction::operation;
  if (is_bit(row)) return (operation ? operations_ : events_).is_forced(row.index);
  return (operation ? operation_values_ : event_values_).is_forced(row.index);
}

void Engine::forget_changed_events() noexcept {
  event_changes_.forget();
  changed_event_slots_.clear();
  if (head_->cycle == 0) return;
  pulses_.forget();
  // Plant time did not advance in a whole cycle, in which the link has shown what is on.
  if (head_->now == cycle_end_) recent_rises_.forget();
  cycle_end_ = head_->now;
}

void Engine::show_on_request(std::span<const std::uint64_t> events) noexcept {
  std::copy_n(events.begin(), std::min<std::size_t>(events.size(), tables_.event_bits / 64), on_request_);
}

void Engine::force(std::uint32_t symbol, bool forced, std::uint64_t value) noexcept {
  override_symbol(symbol, {forced ? Override::Kind::value : Override::Kind::none, false, value});
  if (!forced) malfunctions_.override_again(symbol);
}

/// `to`: a value is in bits.
void Engine::override_symbol(std::uint32_t symbol, const Override& to) noexcept {
  const tables::SymbolRow& row = tables_.symbols[symbol];
  const bool operation = row.direction() == tables::Direction::operation;
  const SharedPositions& shared = operation ? index_.shared_operations : index_.shared_events;
  head_->waits |= kActed;
  unpublished_ = true;
  if (is_bit(row)) {
    BitPlane& plane = operation ? operations_ : events_;
    for_address(shared, true, row.index, [&](std::uint32_t bit) {
      const bool was = plane.is_overridden(bit);
      const bool is = to.kind != Override::Kind::none;
      if (!operation && was != is) is ? ++head_->event_forces : --head_->event_forces;
      const bool on = (to.value != 0) != has_bit(operation ? index_.inverted_operations : index_.inverted_events, bit);
      plane.set(bit, {to.kind, to.by_malfunction, on ? std::uint64_t{1} : 0});
    });
    see_events();
    return;
  }
  ValuePlane& plane = operation ? operation_values_ : event_values_;
  for_address(shared, false, row.index, [&](std::uint32_t slot) { plane.set(slot, to); });
}

/// Touches the units whose custom behavior reads a numeric symbol.
void Engine::touch_readers(tables::Direction direction, std::uint32_t slot) noexcept {
  for (const ValueReader& reader : index_.value_readers.of(direction, slot)) touch(reader.unit);
}

void Engine::set_state(std::uint32_t unit, std::uint8_t target) noexcept {
  UnitState& state = units_[unit];
  const tables::UnitRow& row = tables_.units[unit];
  const TypeIndex& type = index_.types[row.type];
  const std::uint8_t before = state.state;
  const bool moving = (state.flags & kMoving) != 0;
  clear_wheel(unit);
  state.holding = 0;
  state.target = target;
  if (!moving) {
    state.flags |= kMoving;  // as in every move while the old state is left
    switch_events(row, type.at[before].leave);
    if (behaves(unit)) report_left(unit, before);
  }
  state.state = target;
  state.transition = kNoTransition;
  state.flags &= static_cast<std::uint16_t>(~(kMoving | kMidway | kConflict | kStopped));
  switch_events(row, type.at[target].enter);
  if (behaves(unit)) report_entered(unit, target);
  stepped(unit, row);
  touch(unit);
  head_->waits |= kActed;
}

/// Updates unseen_events_, after forces of events changed.
void Engine::see_events() noexcept {
  unseen_events_ = head_->event_forces == 0 && index_.event_watches.empty() && index_.shared_events.empty();
}

void Engine::set_quality(std::size_t behaviour, bool well) noexcept {
  BehaviourState& state = behaviour_states_[behaviour];
  if ((state.ill == 0) == well) return;
  state.ill = well ? 0 : 1;
  touch(tables_.behaviour_units[behaviour].unit);
  head_->waits |= kActed;
}

void Engine::make_event_value(std::uint32_t slot, std::uint64_t value) noexcept {
  unpublished_ = true;
  for_address(index_.shared_events, false, slot, [&](std::uint32_t position) {
    event_values_.made[position] = value;
    event_values_.dirty.mark(position);
  });
}

/// Switches the other events that share an address with those given.
void Engine::make_followers(std::uint32_t word, std::uint64_t on, std::uint64_t off) noexcept {
  for (std::uint64_t bits = on | off; bits != 0; bits &= bits - 1) {
    const std::uint64_t bit = bits & (~bits + 1);
    const std::uint32_t position = word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits));
    for (const SharedPosition& other : index_.shared_events.with(position)) {
      const std::uint32_t other_word = other.position / 64;
      const bool opposite =
          has_bit(index_.inverted_events, position) != has_bit(index_.inverted_events, other.position);
      events_.make(other_word, with_bit(events_.made(other_word), other.position, ((on & bit) != 0) != opposite));
    }
  }
}

bool Engine::restore(std::span<const std::byte> block) noexcept {
  BlockHead other{};
  if (block.size() != block_size_) return false;
  std::memcpy(&other, block.data(), sizeof other);
  if (other.magic != head_->magic || other.model != head_->model || other.size != block_size_) return false;
  const tables::Time cycle = head_->cycle;  // of this run, not of the one that was saved
  std::memmove(reinterpret_cast<std::byte*>(head_), block.data(), block.size());
  head_->cycle = cycle;
  cycle_end_ = -1;
  for (const tables::BehaviourUnit& behaviour : tables_.behaviour_units) {  // custom behaviors are not in the block
    std::uint16_t& flags = units_[behaviour.unit].flags;
    flags &= static_cast<std::uint16_t>(~kBehaves);
    if (behaviour_of(general_row(behaviour.unit)) != nullptr) flags |= kBehaves;
  }
  touched_.size = moved_.size = 0;
  flow_.forget_changes();
  if (values_.active()) {
    values_.forget_changes();
    values_.show_all();
  }
  malfunctions_.forget_changes();
  malfunctions_.mark_all();
  unpublished_ = true;
  see_events();
  if ((head_->waits & (kNotStarted | kActed)) != 0) requeue();
  event_changes_.note_all(tables_.event_bits / 64);
  for (std::uint32_t slot = 0; slot < tables_.event_slots; ++slot) changed_event_slots_.mark(slot);
  return true;
}

bool Engine::put(const tables::PartLocation& to, std::uint32_t kind) noexcept {
  if (!flow_.put(to, kind)) return false;
  head_->waits |= kActed;
  return true;
}

bool Engine::take(const tables::PartLocation& from) noexcept {
  if (!flow_.take(from)) return false;
  head_->waits |= kActed;
  return true;
}

bool Engine::set_value(std::uint32_t value, double number) noexcept {
  if (!values_.set(value, number)) return false;
  head_->waits |= kActed;
  return true;
}

/// Queues the units that were touched in the saved plant for the next instant.
void Engine::requeue() noexcept {
  flow_.mark_all();
  values_.requeue();
  for (std::uint32_t unit = 0; unit < tables_.units.size(); ++unit) {
    const std::uint16_t flags = units_[unit].flags;
    if ((flags & kTouched) != 0) touched_.add(unit);
    if ((flags & kDriven) != 0) moved_.add(unit);
  }
}

}  // namespace symplant::engine

// The engine's memory, its start, and the instants between two calls.
#include "symplant/core/engine.hpp"

#include <algorithm>
#include <bit>
#include <new>

namespace symplant::core {
namespace {

constexpr std::uint64_t bit_in_word(std::uint32_t bit) noexcept { return std::uint64_t{1} << (bit % 64); }

/// Sets a slot, and all that share its address.
void set_all(std::uint64_t* values, const SharedPlaces& shared, std::uint32_t slot, std::uint64_t value) noexcept {
  values[slot] = value;
  for (const SharedPlace& other : shared.with(kSharedSlot + slot)) values[other.place - kSharedSlot] = value;
}

}  // namespace

void DirtySet::take(Arena& arena, std::size_t places) noexcept {
  list = {arena.take<std::uint32_t>(places), 0};
  marks = arena.take<std::uint64_t>((places + 63) / 64);
}

bool DirtySet::mark(std::uint32_t place) noexcept {
  std::uint64_t& word = marks[place / 64];
  if ((word & bit_in_word(place)) != 0) return false;
  word |= bit_in_word(place);
  list.add(place);
  return true;
}

void DirtySet::clear() noexcept {
  for (const std::uint32_t place : list.view()) marks[place / 64] = 0;
  list.size = 0;
}

Engine* Engine::make(const PlantTables& tables, Arena& arena) noexcept {
  auto* raw = arena.take<std::max_align_t>((sizeof(Engine) + sizeof(std::max_align_t) - 1) / sizeof(std::max_align_t));
  if (raw == nullptr) {
    Engine counting(tables);
    counting.place(arena);
    return nullptr;
  }
  auto* engine = new (raw) Engine(tables);
  engine->place(arena);
  return engine;
}

void Engine::place(Arena& arena) noexcept {
  const std::size_t unit_count = tables_.units.size();
  const std::size_t operation_words = tables_.operation_bits / 64;
  const std::size_t event_words = tables_.event_bits / 64;

  head = arena.take<BlockHead>(1);
  units = arena.take<UnitState>(unit_count);
  written_operations = arena.take<std::uint64_t>(operation_words);
  operations = arena.take<std::uint64_t>(operation_words);
  disarmed = arena.take<std::uint64_t>(operation_words);
  events = arena.take<std::uint64_t>(event_words);
  written_values = arena.take<std::uint64_t>(tables_.operation_slots);
  operation_values = arena.take<std::uint64_t>(tables_.operation_slots);
  event_values = arena.take<std::uint64_t>(tables_.event_slots);
  written_words.take(arena, operation_words);
  written_slots.take(arena, tables_.operation_slots);

  changed_events.take(arena, event_words);
  index_.build(tables_, arena);
  current_ = {arena.take<std::uint32_t>(unit_count), 0};
  coming_ = {arena.take<std::uint32_t>(unit_count), 0};
  stepped_ = {arena.take<std::uint32_t>(unit_count), 0};
  touched_events_.take(arena, event_words);
  events_before_ = arena.take<std::uint64_t>(event_words);
  operation_changes_ = {arena.take<WordChange>(operation_words), 0};
  event_changes_ = {arena.take<WordChange>(event_words), 0};
  slot_changes_ = {arena.take<std::uint32_t>(tables_.operation_slots), 0};
}

void Engine::reset() noexcept {
  const auto zero = [](std::uint64_t* words, std::size_t count) { std::fill(words, words + count, 0); };
  for (auto* plane : {written_operations, operations, disarmed}) zero(plane, tables_.operation_bits / 64);
  zero(events, tables_.event_bits / 64);
  for (auto* plane : {written_values, operation_values}) zero(plane, tables_.operation_slots);
  zero(event_values, tables_.event_slots);
  for (auto* set : {&written_words, &written_slots, &changed_events, &touched_events_}) set->clear();
  current_.size = coming_.size = stepped_.size = 0;

  head->now = 0;
  head->started = 0;
  head->wheel.clear();
  for (std::uint32_t unit = 0; unit < tables_.units.size(); ++unit) {
    const UnitRow& row = tables_.units[unit];
    units[unit] = {};
    units[unit].state = units[unit].target = row.initial;
    write_events(row, index_.types[row.type].enter[row.initial], true);
    await_automatic(unit, row, index_.types[row.type]);
  }
  for (const InitialValue& initial : tables_.initial_values) {
    const SymbolRow& symbol = tables_.symbols[initial.symbol];
    const bool is_bit = symbol.type() == DataType::boolean;
    if (symbol.direction() == Direction::event) {
      if (is_bit) {
        write_event_bits(symbol.index / 64, bit_in_word(symbol.index), initial.value != 0);
      } else {
        set_all(event_values, index_.shared_events, symbol.index, initial.value);
      }
    } else if (!is_bit) {
      set_all(written_values, index_.shared_operations, symbol.index, initial.value);
      set_all(operation_values, index_.shared_operations, symbol.index, initial.value);
    }
  }
}

void Engine::write_operation(std::uint32_t bit, bool on) noexcept {
  const auto write = [&](std::uint32_t place) {
    std::uint64_t& word = written_operations[place / 64];
    word = on ? word | bit_in_word(place) : word & ~bit_in_word(place);
    written_words.mark(place / 64);
  };
  write(bit);
  if (index_.shared_operations.empty()) return;
  for (const SharedPlace& other : index_.shared_operations.with(bit)) write(other.place);
}

void Engine::write_operation_value(std::uint32_t slot, std::uint64_t value) noexcept {
  const auto write = [&](std::uint32_t place) {
    written_values[place] = value;
    written_slots.mark(place);
  };
  write(slot);
  if (index_.shared_operations.empty()) return;
  for (const SharedPlace& other : index_.shared_operations.with(kSharedSlot + slot)) write(other.place - kSharedSlot);
}

Time Engine::next_due() const noexcept { return head->started == 0 ? head->now : head->wheel.peek(units); }

void Engine::advance_to(Time target, Observer* observer) noexcept {
  target = std::max(target, head->now);
  if (head->started == 0) {
    const bool now = target == head->now;
    head->started = 1;
    for (std::uint32_t unit = 0; unit < tables_.units.size(); ++unit) queue(unit);
    instant(head->now, now, observer);
    if (now) return;
  }
  for (;;) {
    const Time due = head->wheel.earliest(units, target);
    const bool written = (written_words.list.size | written_slots.list.size) != 0;
    if (due != kNever && due < target) {
      queue_due(due);
      instant(due, false, observer);
    } else if ((due != kNever && due == target) || written) {
      if (due != kNever && due == target) queue_due(due);
      instant(target, true, observer);
    } else {
      head->now = target;
      return;
    }
  }
}

void Engine::queue_due(Time time) noexcept {
  for (std::uint32_t unit = head->wheel.take(time); unit != Wheel::kNone; unit = units[unit].next) {
    units[unit].flags &= static_cast<std::uint8_t>(~kTimed);
    queue(unit);
  }
}

void Engine::queue(std::uint32_t unit) noexcept {
  if ((units[unit].flags & kQueued) != 0) return;
  units[unit].flags |= kQueued;
  coming_.add(unit);
}

void Engine::instant(Time at, bool sample, Observer* observer) noexcept {
  head->now = at;
  if (sample) sample_operations();
  run_rounds();
  close_instant(observer);
}

void Engine::sample_operations() noexcept {
  for (const std::uint32_t word : written_words.list.view()) {
    std::uint64_t changed = operations[word] ^ written_operations[word];
    if (changed == 0) continue;
    operations[word] = written_operations[word];
    disarmed[word] &= operations[word];  // a round that sees an operation off arms it
    operation_changes_.add({word, changed});
    for (; changed != 0; changed &= changed - 1) {
      const std::uint32_t unit =
          index_.unit_of_operation[word * 64 + static_cast<std::uint32_t>(std::countr_zero(changed))];
      if (unit != kNoUnit) queue(unit);
    }
  }
  written_words.clear();
  for (const std::uint32_t slot : written_slots.list.view()) {
    if (operation_values[slot] == written_values[slot]) continue;
    operation_values[slot] = written_values[slot];
    slot_changes_.add(slot);
  }
  written_slots.clear();
}

void Engine::run_rounds() noexcept {
  while (coming_.size != 0) {
    std::swap(current_, coming_);
    coming_.size = 0;
    for (const std::uint32_t unit : current_.view()) units[unit].flags &= static_cast<std::uint8_t>(~kQueued);
    for (const std::uint32_t unit : current_.view()) step(unit);
    current_.size = 0;
  }
}

void Engine::close_instant(Observer* observer) noexcept {
  for (const std::uint32_t word : touched_events_.list.view()) {
    const std::uint64_t changed = events_before_[word] ^ events[word];
    if (changed == 0) continue;
    event_changes_.add({word, changed});
    changed_events.mark(word);
  }
  touched_events_.clear();
  if (observer != nullptr &&
      (stepped_.size | operation_changes_.size | event_changes_.size | slot_changes_.size) != 0) {
    observer->instant(
        {head->now, stepped_.view(), operation_changes_.view(), event_changes_.view(), slot_changes_.view(), {}});
  }
  for (const std::uint32_t unit : stepped_.view()) units[unit].flags &= static_cast<std::uint8_t>(~kStepped);
  stepped_.size = operation_changes_.size = event_changes_.size = slot_changes_.size = 0;
}

void Engine::write_events(const UnitRow& row, std::uint64_t bits, bool on) noexcept {
  if (bits != 0) write_event_bits(row.event_bit / 64, bits << (row.event_bit % 64), on);
}

void Engine::write_event_bits(std::uint32_t word, std::uint64_t bits, bool on) noexcept {
  const auto write = [&](std::uint32_t at, std::uint64_t mask) {
    if (touched_events_.mark(at)) events_before_[at] = events[at];
    events[at] = on ? events[at] | mask : events[at] & ~mask;
  };
  write(word, bits);
  if (index_.shared_events.empty()) return;
  for (; bits != 0; bits &= bits - 1) {
    const std::uint32_t place = word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits));
    for (const SharedPlace& other : index_.shared_events.with(place)) {
      write(other.place / 64, bit_in_word(other.place));
    }
  }
}

}  // namespace symplant::core

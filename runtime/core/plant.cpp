// The Plant interface over the engine.
#include "symplant/core/plant.hpp"

#include <algorithm>

#include "symplant/core/arena.hpp"
#include "symplant/core/engine.hpp"

namespace symplant::core {
namespace {

bool bit_of(const std::uint64_t* plane, std::uint32_t bit) noexcept {
  return ((plane[bit / 64] >> (bit % 64)) & 1) != 0;
}

}  // namespace

std::size_t Plant::memory_size(const PlantTables& tables) noexcept {
  Arena counting(nullptr);
  Engine::make(tables, counting);
  return counting.used();
}

Plant::Plant(const PlantTables& tables, std::span<std::byte> memory) noexcept : tables_(tables) {
  Arena arena(memory.data());
  engine_ = Engine::make(tables, arena);
  engine_->reset();
}

void Plant::reset() noexcept { engine_->reset(); }

void Plant::set_operation(std::uint32_t bit, bool on) noexcept { engine_->write_operation(bit, on); }

void Plant::set_operation_value(std::uint32_t slot, std::uint64_t value) noexcept {
  engine_->write_operation_value(slot, value);
}

void Plant::advance_to(Time time, Observer* observer) noexcept { engine_->advance_to(time, observer); }

Time Plant::now() const noexcept { return engine_->head->now; }

Time Plant::next_due() noexcept { return engine_->next_due(); }

bool Plant::operation(std::uint32_t bit) const noexcept { return bit_of(engine_->operations, bit); }

bool Plant::event(std::uint32_t bit) const noexcept { return bit_of(engine_->events, bit); }

std::uint64_t Plant::operation_value(std::uint32_t slot) const noexcept { return engine_->operation_values[slot]; }

std::uint64_t Plant::event_value(std::uint32_t slot) const noexcept { return engine_->event_values[slot]; }

std::span<const std::uint64_t> Plant::operations() const noexcept {
  return {engine_->operations, tables_.operation_bits / 64};
}

std::span<const std::uint64_t> Plant::events() const noexcept { return {engine_->events, tables_.event_bits / 64}; }

std::span<const std::uint32_t> Plant::changed_events() const noexcept { return engine_->changed_events.list.view(); }

void Plant::forget_changed_events() noexcept { engine_->changed_events.clear(); }

UnitView Plant::unit(std::uint32_t unit) const noexcept {
  const UnitState& state = engine_->units[unit];
  const bool moving = (state.flags & kMoving) != 0;
  if (!moving) return {state.state, state.state, false, 0, 0.0};
  const Time remaining = (state.flags & kStanding) != 0 ? state.due : std::max<Time>(state.due - now(), 0);
  const double whole = static_cast<double>(state.mark);
  return {state.state, state.target, true, remaining,
          state.mark == 0 ? 1.0 : 1.0 - static_cast<double>(remaining) / whole};
}

}  // namespace symplant::core

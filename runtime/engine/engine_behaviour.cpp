// Calls custom behaviors, and implements their view of a unit.
#include <algorithm>
#include <exception>

#include "symplant/engine/behaviour.hpp"
#include "symplant/engine/draw.hpp"
#include "symplant/engine/engine_inline.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::engine {
namespace {

constexpr std::uint16_t kOwnStream = 0xFFFF;

}  // namespace

void Engine::start_behaviours() noexcept {
  for (std::uint32_t position = 0; position < tables_.behaviour_units.size(); ++position) {
    const std::uint32_t unit = tables_.behaviour_units[position].unit;
    const Behaviour* behaviour = behaviour_of(general_row(unit));
    if (behaviour == nullptr || behaviour->started == nullptr) continue;
    BehaviourView view(*this, unit, position);
    behaviour->started(view);
  }
}

void Engine::wake_behaviour(std::uint32_t unit, const tables::UnitRow& row) noexcept {
  const GeneralRow& general = general_row(unit);
  const Behaviour* behaviour = behaviour_of(general);
  if (behaviour_states_[general.behaviour].woken == 0) return;
  behaviour_states_[general.behaviour].woken = 0;
  stepped(unit, row);
  BehaviourView view(*this, unit, general.behaviour);
  if (behaviour->woken != nullptr) behaviour->woken(view);
}

void Engine::report_left(std::uint32_t unit, std::uint8_t state) noexcept {
  const GeneralRow& general = general_row(unit);
  const Behaviour* behaviour = behaviour_of(general);
  if (behaviour->left == nullptr) return;
  BehaviourView view(*this, unit, general.behaviour);
  behaviour->left(view, state);
}

void Engine::report_entered(std::uint32_t unit, std::uint8_t state) noexcept {
  const GeneralRow& general = general_row(unit);
  const Behaviour* behaviour = behaviour_of(general);
  if (behaviour->entered == nullptr) return;
  BehaviourView view(*this, unit, general.behaviour);
  behaviour->entered(view, state);
}

std::uint8_t Engine::wanted_by_behaviour(std::uint32_t unit) noexcept {
  const GeneralRow& general = general_row(unit);
  const Behaviour* behaviour = behaviour_of(general);
  if (behaviour->wanted == nullptr) return tables::kNoState;
  BehaviourView view(*this, unit, general.behaviour);
  const std::uint8_t wanted = behaviour->wanted(view);
  return wanted < index_.types[tables_.units[unit].type].states ? wanted : tables::kNoState;
}

void Engine::wake_at(std::uint32_t behaviour, tables::Time time) noexcept {
  const std::uint32_t unit = tables_.behaviour_units[behaviour].unit;
  BehaviourState& state = behaviour_states_[behaviour];
  const std::uint32_t entry = wheel_entry_of_behaviour(behaviour);
  clear_wheel(entry);
  state.wake = time;
  state.woken = 0;
  if (time == tables::kNever) return;
  if ((units_[unit].flags & kHalted) != 0) {
    state.wake = time <= head_->now ? 0 : time - head_->now;
  } else if (time <= head_->now) {
    state.wake = tables::kNever;
    state.woken = 1;
    queue(unit);
  } else {
    set_wheel(entry, time);
  }
}

tables::Time BehaviourView::now() const noexcept { return engine_.head_->now; }
std::uint8_t BehaviourView::state() const noexcept { return engine_.units_[unit_].state; }
std::uint8_t BehaviourView::target() const noexcept {
  return moving() ? engine_.units_[unit_].target : engine_.units_[unit_].state;
}
bool BehaviourView::moving() const noexcept { return (engine_.units_[unit_].flags & kMoving) != 0; }

bool BehaviourView::operation(std::uint8_t operation) const noexcept {
  const tables::UnitRow& row = engine_.tables_.units[unit_];
  return (engine_.operations_on(row, engine_.index_.types[row.type]) & operation_mask(operation)) != 0;
}

bool BehaviourView::event(std::uint8_t event) const noexcept {
  const std::uint32_t bit = engine_.tables_.units[unit_].event_bit + event;
  return (engine_.events_.made(bit / 64) & bit_in_word(bit)) != 0;
}

bool BehaviourView::input(std::uint32_t input) const noexcept {
  const tables::BehaviourUnit& row = engine_.tables_.behaviour_units[position_];
  return engine_.truth(engine_.general_row(unit_).first_condition + row.first_input + input);
}

std::uint64_t BehaviourView::value(std::uint32_t value) const noexcept {
  const std::uint32_t first = engine_.tables_.behaviour_units[position_].first_value;
  const tables::SymbolRow& symbol = engine_.tables_.symbols[engine_.tables_.behaviour_values[first + value]];
  return symbol.direction() == tables::Direction::operation ? engine_.operation_values_.values[symbol.index]
                                                            : engine_.event_values_.made[symbol.index];
}

bool BehaviourView::quality() const noexcept { return engine_.behaviour_states_[position_].ill == 0; }

void BehaviourView::set_event(std::uint8_t event, bool on) noexcept {
  const tables::UnitRow& row = engine_.tables_.units[unit_];
  if (event >= engine_.index_.types[row.type].events) return;
  const std::uint64_t mask = operation_mask(event);
  engine_.switch_events(row, {on ? mask : 0, on ? 0 : mask});
}

void BehaviourView::set_value(std::uint32_t value, std::uint64_t bits) noexcept {
  const std::uint32_t first = engine_.tables_.behaviour_units[position_].first_value;
  const tables::SymbolRow& symbol = engine_.tables_.symbols[engine_.tables_.behaviour_values[first + value]];
  if (symbol.direction() == tables::Direction::event) engine_.make_event_value(symbol.index, bits);
}

void BehaviourView::wake_at(tables::Time time) noexcept { engine_.wake_at(position_, time); }

std::uint64_t BehaviourView::draw() noexcept {
  std::uint64_t state = draw_start(engine_.head_->seed, engine_.name_hash(unit_), kOwnStream,
                                   engine_.behaviour_states_[position_].draws++);
  return split_mix(state);
}

std::uint32_t BehaviourView::behaviour() const noexcept { return engine_.tables_.behaviour_units[position_].name; }

std::span<const Behaviour> BehaviourView::behaviours() const noexcept { return engine_.behaviours_; }

const tables::Transition* BehaviourView::transition(std::uint16_t number) const noexcept {
  const auto rows = engine_.tables_.types[engine_.tables_.units[unit_].type].transitions;
  return number < rows.size() ? &rows[number] : nullptr;
}

tables::Time BehaviourView::model_takes(std::uint16_t transition) noexcept {
  const tables::UnitRow& row = engine_.tables_.units[unit_];
  return engine_.takes_by_model(unit_, row, engine_.index_.types[row.type], leads_to_, transition);
}

tables::Time BehaviourView::model_after(std::uint16_t transition) noexcept {
  const tables::UnitRow& row = engine_.tables_.units[unit_];
  return engine_.after_by_model(unit_, row, engine_.index_.types[row.type], transition);
}

void* BehaviourView::memory_bytes(std::size_t size) noexcept {
  if (size > engine_.memory_of(position_)) std::terminate();
  return engine_.behaviour_memory_ + engine_.memory_begins_[position_];
}

}  // namespace symplant::engine

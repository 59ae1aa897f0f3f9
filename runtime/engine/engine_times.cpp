// Travel times and delays, fixed and random, and their halt while a unit is disabled or frozen.
#include <algorithm>

#include "symplant/engine/draw.hpp"
#include "symplant/engine/engine_inline.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::engine {

/// A time of the tables: `time` itself, or a draw if it refers to a random time.
tables::Time Engine::drawn(std::uint32_t unit, const TypeIndex& type, std::uint16_t transition,
                           tables::Time time) noexcept {
  if (time >= 0) return time;
  Record& record = records_[general_row(unit).first_record + type.record_of[transition]];
  const std::uint64_t start = draw_start(head_->seed, name_hash(unit), transition, record.draws++);
  return random_time(tables_.random_times[static_cast<std::size_t>(-1 - time)], start);
}

tables::Time Engine::after_by_model(std::uint32_t unit, const tables::UnitRow& row, std::uint16_t transition) noexcept {
  const TypeIndex& type = index_.types[row.type];
  return drawn(unit, type, transition, times_of(row, type, type.transitions[transition].dt).after);
}

tables::Time Engine::after(std::uint32_t unit, const tables::UnitRow& row, std::uint16_t transition) noexcept {
  if (behaves(unit)) {
    const GeneralRow& general = general_row(unit);
    const Behaviour* behaviour = behaviour_of(general);
    if (behaviour->after != nullptr) {
      BehaviourView view(*this, unit, general.behaviour);
      return std::max<tables::Time>(0, behaviour->after(view, transition));
    }
  }
  return after_by_model(unit, row, transition);
}

tables::Time Engine::takes_by_model(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                                    std::uint8_t target, std::uint16_t transition) noexcept {
  if (transition == kNoTransition) {
    transition = transition_without_command(type, units_[unit].state, target);
    if (transition == kNoTransition) return times_of(row, type, type.travel).takes;
  }
  return drawn(unit, type, transition, times_of(row, type, type.transitions[transition].dt).takes);
}

/// The travel time of the transition, or of a move without a command to `target`.
tables::Time Engine::takes(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type, std::uint8_t target,
                           std::uint16_t transition) noexcept {
  if (behaves(unit)) {
    const GeneralRow& general = general_row(unit);
    const Behaviour* behaviour = behaviour_of(general);
    if (behaviour->takes != nullptr) {
      BehaviourView view(*this, unit, general.behaviour, target);
      return std::max<tables::Time>(0, behaviour->takes(view, transition));
    }
  }
  return takes_by_model(unit, row, type, target, transition);
}

std::uint16_t Engine::transition_without_command(const TypeIndex& type, std::uint8_t from,
                                                 std::uint8_t to) const noexcept {
  for (const std::uint16_t n : type.from(from)) {
    if (type.transitions[n].to == to && type.transitions[n].on != tables::kNoOperation) return n;
  }
  return kNoTransition;
}

/// Replaces all times of a unit by the time left.
void Engine::halt_times(std::uint32_t unit) noexcept {
  UnitState& state = units_[unit];
  const tables::UnitRow& row = tables_.units[unit];
  clear_wheel(unit);
  if ((state.flags & (kMoving | kMidway)) == kMoving && state.due != tables::kNever) state.due -= head_->now;
  if (row.general == 0) return;
  const GeneralRow& general = general_row(unit);
  const TypeIndex& type = index_.types[row.type];
  for (std::uint32_t r = 0; r < type.records; ++r) {
    Record& record = records_[general.first_record + r];
    if (record.holds != 0 && record.ready != tables::kNever)
      record.ready = std::max<tables::Time>(0, record.ready - head_->now);
  }
  if (general.behaviour == tables::kNone) return;
  clear_wheel(wheel_entry_of_behaviour(general.behaviour));
  tables::Time& wake = behaviour_states_[general.behaviour].wake;
  if (wake != tables::kNever) wake -= head_->now;
}

void Engine::resume_times(std::uint32_t unit) noexcept {
  UnitState& state = units_[unit];
  const tables::UnitRow& row = tables_.units[unit];
  if ((state.flags & (kMoving | kMidway)) == kMoving && state.due != tables::kNever) {
    state.due = later(head_->now, state.due);
    if (state.due > head_->now && state.due != tables::kNever) head_->wheel.insert(units_, unit, state.due);
  }
  if (row.general == 0) return;
  const GeneralRow& general = general_row(unit);
  const TypeIndex& type = index_.types[row.type];
  for (std::uint32_t r = 0; r < type.records; ++r) {
    Record& record = records_[general.first_record + r];
    if (record.holds != 0) record.ready = later(head_->now, record.ready);  // the next round puts it in the wheel
  }
  if (general.behaviour == tables::kNone) return;
  BehaviourState& behaviour = behaviour_states_[general.behaviour];
  if (behaviour.wake != tables::kNever) wake_at(general.behaviour, later(head_->now, behaviour.wake));
}

}  // namespace symplant::engine

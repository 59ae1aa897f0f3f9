// Travel times and delays, fixed and random, and their halt while a unit is disabled or frozen.
#include <algorithm>

#include "symplant/engine/draw.hpp"
#include "symplant/engine/engine_inline.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::engine {

/// A draw of the random time to which `time` < 0 of the tables refers.
tables::Time Engine::drawn(std::uint32_t unit, const TypeIndex& type, std::uint16_t transition,
                           tables::Time time) noexcept {
  Record& record = records_[general_row(unit).first_record + type.record_of[transition]];
  const std::uint64_t start = draw_start(head_->seed, name_hash(unit), transition, record.draws++);
  return random_time(tables_.random_times[static_cast<std::size_t>(-1 - time)], start);
}

tables::Time Engine::after_by_behaviour(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                                        std::uint16_t transition) noexcept {
  const GeneralRow& general = general_row(unit);
  const Behaviour* behaviour = behaviour_of(general);
  if (behaviour->after == nullptr) return after_by_model(unit, row, type, transition);
  BehaviourView view(*this, unit, general.behaviour);
  return std::max<tables::Time>(0, behaviour->after(view, transition));
}

/// The travel time of a unit with a custom behavior, or that a malfunction slows.
tables::Time Engine::takes_otherwise(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                                     std::uint8_t target, std::uint16_t transition) noexcept {
  const tables::Time time = behaves(unit) ? takes_by_behaviour(unit, row, type, target, transition)
                                          : takes_by_model(unit, row, type, target, transition);
  return (units_[unit].flags & kSlowed) != 0 ? malfunctions_.slowed(unit, row, time) : time;
}

tables::Time Engine::takes_by_behaviour(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                                        std::uint8_t target, std::uint16_t transition) noexcept {
  const GeneralRow& general = general_row(unit);
  const Behaviour* behaviour = behaviour_of(general);
  if (behaviour->takes == nullptr) return takes_by_model(unit, row, type, target, transition);
  BehaviourView view(*this, unit, general.behaviour, target);
  return std::max<tables::Time>(0, behaviour->takes(view, transition));
}

std::uint16_t Engine::transition_without_command(const TypeIndex& type, std::uint8_t from,
                                                 std::uint8_t to) const noexcept {
  for (const std::uint16_t n : type.from(from)) {
    if (type.transitions[n].to == to && type.transitions[n].on != tables::kNoOperation) return n;
  }
  return kNoTransition;
}

tables::Time Engine::whole(std::uint32_t unit) const noexcept {
  const UnitState& state = units_[unit];
  if ((state.flags & kMoving) == 0) return 0;
  const tables::UnitRow& row = tables_.units[unit];
  if (row.general != 0) return general_state(unit).whole;
  std::uint16_t transition = state.transition;
  const tables::Time time = travel_time(row, index_.types[row.type], state.state, state.target,
                                        transition);  // neither random nor replaced
  return (state.flags & kSlowed) != 0 ? malfunctions_.whole(unit, time) : time;
}

tables::Time Engine::after_left(std::uint32_t unit, std::uint16_t transition) const noexcept {
  const UnitState& state = units_[unit];
  const tables::UnitRow& row = tables_.units[unit];
  const std::uint16_t record_of = index_.types[row.type].record_of[transition];
  const bool counts = row.general != 0 && record_of != kNoRecord && state.holding != 0 && (state.flags & kMoving) == 0;
  if (!counts) return tables::kNever;
  const Record& record = records_[general_row(unit).first_record + record_of];
  if (record.holds == 0 || record.ready == tables::kNever) return tables::kNever;
  return (state.flags & kHalted) != 0 ? record.ready : std::max<tables::Time>(0, record.ready - head_->now);
}

/// Replaces all times of a unit by the time left.
void Engine::halt_times(std::uint32_t unit) noexcept {
  UnitState& state = units_[unit];
  const tables::UnitRow& row = tables_.units[unit];
  clear_wheel(unit);
  if ((state.flags & (kMoving | kMidway)) == kMoving && state.due != tables::kNever) state.due -= head_->now;
  if (row.general == 0) return;
  const GeneralRow& general = general_row(unit);
  const std::uint32_t records = state.holding != 0 ? index_.types[row.type].records : 0;
  for (std::uint32_t r = 0; r < records; ++r) {
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
  const std::uint32_t records = state.holding != 0 ? index_.types[row.type].records : 0;
  for (std::uint32_t r = 0; r < records; ++r) {
    Record& record = records_[general.first_record + r];
    if (record.holds != 0) record.ready = later(head_->now, record.ready);  // the next round puts it in the wheel
  }
  if (general.behaviour == tables::kNone) return;
  BehaviourState& behaviour = behaviour_states_[general.behaviour];
  if (behaviour.wake != tables::kNever) wake_at(general.behaviour, later(head_->now, behaviour.wake));
}

}  // namespace symplant::engine

// Small functions of the engine that several of its files call in every move.
#pragma once

#include "symplant/engine/engine.hpp"

#if defined(__GNUC__)
#define SYMPLANT_ALWAYS_INLINE [[gnu::always_inline]] inline
#else
#define SYMPLANT_ALWAYS_INLINE inline
#endif

namespace symplant::engine {

/// `a` + `b`, both >= 0, or kNever if the sum exceeds kNever.
constexpr tables::Time later(tables::Time a, tables::Time b) noexcept {
  return b > tables::kNever - a ? tables::kNever : a + b;
}

/// fnv1a64 of a name in the upper case of ASCII.
inline std::uint64_t upper_case_hash(std::string_view name) noexcept {
  tables::Fnv1a64 hash;
  for (const char c : name) hash.byte(static_cast<std::uint8_t>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c));
  return hash.value();
}

constexpr std::uint64_t operation_mask(std::uint8_t operation) noexcept { return std::uint64_t{1} << operation; }

inline GeneralState& Engine::general_state(std::uint32_t unit) const noexcept {
  return general_states_[index_.general.position_of(unit)];
}

/// The times of a Transition::dt or of TypeRow::travel.
SYMPLANT_ALWAYS_INLINE const tables::TransitionTimes& Engine::times_of(const tables::UnitRow& row,
                                                                       const TypeIndex& type,
                                                                       std::uint16_t dt) const noexcept {
  if ((dt & tables::kOfDevice) == 0) return type.times[dt];
  return tables_.times[row.times + static_cast<std::uint32_t>(dt ^ tables::kOfDevice)];
}

/// The operations of a unit that are on and armed.
inline std::uint64_t Engine::operations_on(const tables::UnitRow& row, const TypeIndex& type) const noexcept {
  const std::uint32_t word = row.operation_bit / 64;
  return ((operations_.bits[word] & ~disarmed_[word]) >> (row.operation_bit % 64)) & type.operations;
}

SYMPLANT_ALWAYS_INLINE void Engine::touch(std::uint32_t unit) noexcept {
  if ((units_[unit].flags & kTouched) != 0) return;
  units_[unit].flags |= kTouched;
  touched_.add(unit);
}

/// Queues a unit for the next round. Before an instant's first round touching it is enough.
inline void Engine::queue(std::uint32_t unit) noexcept {
  touch(unit);
  if (round_ == 0 || (units_[unit].flags & kQueued) != 0) return;
  units_[unit].flags |= kQueued;
  queue_[queued_++] = unit;
}

/// Marks that a unit stepped in this round.
inline void Engine::stepped(std::uint32_t unit, const tables::UnitRow& row) noexcept {
  active_ = true;
  if (row.general == 0 || (units_[unit].flags & kDriven) != 0) return;
  units_[unit].flags |= kDriven;
  moved_.add(unit);
  unpublished_ = true;
}

/// In suspects_: a malfunction started or ended.
inline constexpr std::uint32_t kMalfunctionsChanged = 1U << 31;

constexpr std::uint32_t suspect(tables::FindingKind kind) noexcept { return 1U << static_cast<std::uint32_t>(kind); }

inline void Engine::make_event_bits(std::uint32_t word, std::uint64_t on, std::uint64_t off) noexcept {
  events_.make(word, (events_.made(word) & ~off) | on);
  unpublished_ = true;
  if (!index_.shared_events.empty()) make_followers(word, on, off);
}

inline void Engine::switch_events(const tables::UnitRow& row, const tables::EventMasks& masks) noexcept {
  if ((masks.on | masks.off) == 0) return;
  const std::uint32_t shift = row.event_bit % 64;
  make_event_bits(row.event_bit / 64, masks.on << shift, masks.off << shift);
}

/// Whether a condition watches the word of events, or one of them is forced or shared: then changes must wait for the
/// end of the round.
SYMPLANT_ALWAYS_INLINE bool Engine::events_are_seen(std::uint32_t word) const noexcept {
  return !unseen_events_ &&
         (events_.forced[word] != 0 || index_.event_watches.watched(word) != 0 || !index_.shared_events.empty());
}

/// As switch_events(), by the one step of a unit in this round. If no condition watches the word and none of its events
/// is forced or shared, the change is made at once: no other unit can observe it within the round.
SYMPLANT_ALWAYS_INLINE void Engine::switch_events_now(const tables::UnitRow& row,
                                                      const tables::EventMasks& masks) noexcept {
  if ((masks.on | masks.off) == 0) return;  // a unit without events may lie after the plane's last word
  const std::uint32_t word = row.event_bit / 64;
  if (events_are_seen(word) || events_.dirty.has(word)) {
    switch_events(row, masks);
    return;
  }
  const std::uint32_t shift = row.event_bit % 64;
  const std::uint64_t before = events_.bits[word];
  const std::uint64_t now = (before & ~(masks.off << shift)) | (masks.on << shift);
  if (now == before) return;
  event_changes_.note(word, before);
  events_.bits[word] = now;
}

inline void Engine::clear_wheel(std::uint32_t entry) noexcept {
  if ((units_[entry].flags & kTimed) != 0) head_->wheel.remove(units_, entry);
}

inline void Engine::set_wheel(std::uint32_t entry, tables::Time due) noexcept {
  clear_wheel(entry);
  units_[entry].due = due;
  if (due != tables::kNever) head_->wheel.insert(units_, entry, due);
}

SYMPLANT_ALWAYS_INLINE void Engine::disable(std::uint32_t unit) noexcept {
  UnitState& state = units_[unit];
  if ((state.flags & kFrozen) == 0) halt_times(unit);
  state.flags &= static_cast<std::uint16_t>(~(kConflict | kStopped));
  state.flags |= kDisabled;
}

/// False if it is frozen; else it gets the given flags.
SYMPLANT_ALWAYS_INLINE bool Engine::enable(std::uint32_t unit, std::uint16_t flags) noexcept {
  UnitState& state = units_[unit];
  state.flags &= static_cast<std::uint16_t>(~kDisabled);
  if ((state.flags & kFrozen) != 0) return false;
  state.flags |= flags;
  resume_times(unit);
  return true;
}

/// Whether a unit settled in `here` may have a cause to leave it: an operation, or for a spring the lack of one.
SYMPLANT_ALWAYS_INLINE bool Engine::may_leave(const tables::UnitRow& row, const TypeIndex& type,
                                              std::uint8_t here) const noexcept {
  const std::uint64_t on = operations_on(row, type);
  if ((on & type.at[here].starts) != 0) return true;
  return type.actuation == tables::Actuation::spring && here != type.rest && (on & type.at[here].leads) == 0;
}

/// Clears `served` and `reported` of operations that fell.
SYMPLANT_ALWAYS_INLINE void Engine::finish_operations(const WordChange& change) noexcept {
  OperationWord& word = operation_words_[change.word];
  const std::uint64_t fallen = change.bits & ~operations_.bits[change.word];
  word.served &= ~fallen;
  if (word.reported != 0) word.reported &= ~fallen;
}

/// Serves the operations that lead to the state in which a unit is settled, or to which it moves, as an instant ends.
SYMPLANT_ALWAYS_INLINE void Engine::serve(const UnitState& state, const tables::UnitRow& row) noexcept {
  const std::uint32_t word = row.operation_bit / 64;
  const std::uint64_t unserved = operations_.bits[word] & ~operation_words_[word].served;
  if (unserved == 0) return;
  const TypeIndex& type = index_.types[row.type];
  if (type.operations == 0) return;
  const std::uint8_t position = (state.flags & kMoving) != 0 ? state.target : state.state;
  operation_words_[word].served |= unserved & (type.at[position].leads << (row.operation_bit % 64));
}

/// Begins a move that takes `duration` > 0.
SYMPLANT_ALWAYS_INLINE void Engine::travel(std::uint32_t unit, UnitState& state, tables::Time duration) noexcept {
  if (duration >= tables::kNever - now_) {
    state.due = tables::kNever;
  } else {
    head_->wheel.insert(units_, unit, now_ + duration);
  }
}

/// How long the cause of a transition must hold.
SYMPLANT_ALWAYS_INLINE tables::Time Engine::after(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                                                  std::uint16_t transition) noexcept {
  if (behaves(unit)) [[unlikely]]
    return after_by_behaviour(unit, row, type, transition);
  return after_by_model(unit, row, type, transition);
}

SYMPLANT_ALWAYS_INLINE tables::Time Engine::after_by_model(std::uint32_t unit, const tables::UnitRow& row,
                                                           const TypeIndex& type, std::uint16_t transition) noexcept {
  const tables::Time time = times_of(row, type, type.transitions[transition].dt).after;
  return time >= 0 ? time : drawn(unit, type, transition, time);
}

/// The travel time of the transition, or of a move without a command to `target`.
SYMPLANT_ALWAYS_INLINE tables::Time Engine::takes(std::uint32_t unit, const tables::UnitRow& row, const TypeIndex& type,
                                                  std::uint8_t target, std::uint16_t transition) noexcept {
  if ((units_[unit].flags & (kBehaves | kSlowed)) != 0) [[unlikely]]
    return takes_otherwise(unit, row, type, target, transition);
  return takes_by_model(unit, row, type, target, transition);
}

/// The travel time of a move as the tables have it. Of a move without a command, `transition` becomes the one whose
/// time it takes.
SYMPLANT_ALWAYS_INLINE tables::Time Engine::travel_time(const tables::UnitRow& row, const TypeIndex& type,
                                                        std::uint8_t from, std::uint8_t to,
                                                        std::uint16_t& transition) const noexcept {
  if (transition == kNoTransition) {
    transition = transition_without_command(type, from, to);
    if (transition == kNoTransition) return times_of(row, type, type.travel).takes;
  }
  return times_of(row, type, type.transitions[transition].dt).takes;
}

SYMPLANT_ALWAYS_INLINE tables::Time Engine::takes_by_model(std::uint32_t unit, const tables::UnitRow& row,
                                                           const TypeIndex& type, std::uint8_t target,
                                                           std::uint16_t transition) noexcept {
  const tables::Time time = travel_time(row, type, units_[unit].state, target, transition);
  return time >= 0 ? time : drawn(unit, type, transition, time);
}

inline tables::Time Flow::now() const noexcept { return engine_.head_->now; }

inline bool Flow::truth(std::uint32_t condition) const noexcept { return engine_.truth(condition); }

inline const Behaviour* Engine::behaviour_of(const GeneralRow& general) const noexcept {
  if (general.behaviour == tables::kNone) return nullptr;
  const std::uint32_t name = tables_.behaviour_units[general.behaviour].name;
  return name < behaviours_.size() ? &behaviours_[name] : nullptr;
}

}  // namespace symplant::engine

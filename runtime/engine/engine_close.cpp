// Closes an instant: net changes, requirements, served operations, findings, and the observer.
#include <algorithm>
#include <bit>

#include "symplant/engine/engine_inline.hpp"

namespace symplant::engine {

/// Events of a word that fall now and rose less than a cycle ago. Only in real time (`cycle` is not 0).
std::uint64_t Engine::close_cycle(std::uint32_t word, std::uint64_t changed) noexcept {
  pulses_.changed(word, changed);
  const std::uint64_t examined = changed & ~on_request_[word];
  const std::uint64_t risen = examined & events_.bits[word];
  const std::uint64_t fallen = examined & ~risen;
  const std::uint64_t found = fallen == 0 ? 0 : recent_rises_.fell(word, fallen, head_->now, head_->cycle);
  if (risen != 0) recent_rises_.rose(word, risen, head_->now);
  return found;
}

/// The net changes of events, if the observer or a finding needs them.
SYMPLANT_ALWAYS_INLINE std::span<const WordChange> Engine::close_events() noexcept {
  const tables::Time cycle = head_->cycle;
  if (observer_ == nullptr && cycle == 0 && !event_changes_.flickered()) return {};
  return event_changes_.close(events_.bits, [&](const WordChange& change, std::uint64_t flickered) {
    std::uint64_t too_short = flickered;
    if (cycle != 0 && change.bits != 0) too_short |= close_cycle(change.word, change.bits);
    if (too_short == 0) return;
    short_events_.add({change.word, too_short});
    suspects_ |= suspect(tables::FindingKind::event_too_short);
  });
}

/// In the first instant operations that are on have risen: those that are inverted unlike others on their address may
/// be on from the start.
void Engine::find_start() noexcept {
  operation_changes_.size = 0;
  for (std::uint32_t word = 0; word < tables_.operation_bits / 64; ++word) {
    if (operations_.bits[word] != 0) operation_changes_.add({word, operations_.bits[word]});
  }
}

/// The first instant reports the bits that are on, not what changed: inverted symbols may be on from the start.
std::span<const WordChange> Engine::report_start() noexcept {
  operation_changes_.size = 0;
  const BitWords bits = operations();
  for (std::uint32_t word = 0; word < bits.size(); ++word) {
    if (bits[word] != 0) operation_changes_.add({word, bits[word]});
  }
  return event_changes_.all_on(events());
}

void Engine::close_event_values() noexcept {
  touched_slots_.take_all([&](std::uint32_t slot) {
    if (values_before_[slot] == event_values_.values[slot]) return;
    event_slot_changes_.add(slot);
    changed_event_slots_.mark(slot);
  });
}

void Engine::close_requirements() noexcept {
  touched_requirements_.take_all([&](std::uint32_t requirement) {
    if (!close_requirement(requirement)) return;
    violated_.add(requirement);
    suspects_ |= suspect(tables::FindingKind::requirement_violated);
  });
}

/// Evaluates a requirement; true if it is violated in this instant.
bool Engine::close_requirement(std::uint32_t requirement) noexcept {
  const tables::RequirementRow& row = tables_.requirements[requirement];
  MonitorState& monitor = monitors_[requirement];
  const bool holds = truth(row.condition);
  const bool begins = holds && monitor.held == 0;
  monitor.held = holds ? 1 : 0;
  if (row.kind == tables::RequirementRow::Kind::never) return begins;

  const std::uint32_t entry = wheel_entry_of_requirement(requirement);
  if (begins && monitor.running == 0) {
    monitor.running = 1;
    monitor.started = head_->now;
    if (row.within > 0) set_wheel(entry, later(head_->now, row.within));
  }
  if (monitor.running == 0) return false;
  const bool met = truth(row.expected);
  if (!met && head_->now < later(monitor.started, row.within)) return false;
  clear_wheel(entry);
  monitor.running = 0;
  return !met || head_->now < later(monitor.started, row.earliest);
}

/// Whether an operation of the word may have a finding: it rose and no transition fired on it, or it fell without
/// having been served.
SYMPLANT_ALWAYS_INLINE bool Engine::may_be_finding(const WordChange& change) const noexcept {
  const OperationWord& word = operation_words_[change.word];
  const std::uint64_t unserved = change.bits & ~word.served;
  if (unserved == 0) return false;
  const std::uint64_t on = operations_.bits[change.word];
  if ((unserved & ~on & ~word.reported) != 0) return true;
  const UnitOfOperation::Word unit_of = index_.unit_of_operation.of_word(change.word);
  for (std::uint64_t bits = unserved & on; bits != 0; bits &= bits - 1) {
    const std::uint32_t unit = unit_of[static_cast<std::uint32_t>(std::countr_zero(bits))];
    if (unit == tables::kNone) continue;
    const UnitState& state = units_[unit];
    if ((state.flags & (kMoving | kHalted)) == kMoving) continue;
    const tables::UnitRow& row = tables_.units[unit];
    const std::uint64_t starts = index_.types[row.type].at[state.state].starts << (row.operation_bit % 64);
    if ((state.flags & kHalted) != 0 || (starts & bits & (~bits + 1)) == 0) return true;
  }
  return false;
}

/// Finishes the changed words, unless an operation may have a finding: then returns true, and the caller finishes them
/// after the findings.
SYMPLANT_ALWAYS_INLINE bool Engine::close_operations() noexcept {
  for (const WordChange& change : operation_changes_.view()) {
    if (!may_be_finding(change)) continue;
    suspects_ |= suspect(tables::FindingKind::command_without_effect) | suspect(tables::FindingKind::lost_command);
    return true;
  }
  for (const WordChange& change : operation_changes_.view()) finish_operations(change);
  return false;
}

SYMPLANT_ALWAYS_INLINE void Engine::finish_units() noexcept {
  constexpr std::uint16_t kOfThisInstant = kTouched | kEnabledNow | kConflictReported | kStoppedReported;
  UnitState* const states = units_;
  const tables::UnitRow* const rows = tables_.units.data();
  for (const std::uint32_t unit : touched_.view()) {
    UnitState& state = states[unit];
    if ((state.flags & kTouched) == 0) continue;  // took the fast path
    serve(state, rows[unit]);
    std::uint16_t flags = state.flags & static_cast<std::uint16_t>(~kOfThisInstant);
    if ((flags & (kConflict | kStopped)) != 0) {
      if ((flags & kConflict) != 0) flags |= kConflictReported;
      if ((flags & kStopped) != 0) flags |= kStoppedReported;
    }
    state.flags = flags;
  }
}

void Engine::close_instant() noexcept {
  std::span<const WordChange> changed_events = close_events();
  if (!touched_slots_.empty()) close_event_values();
  if (!touched_requirements_.empty()) close_requirements();
  if (closes_more_) [[unlikely]] {
    if (first_) find_start();
    if (!index_.overruns.empty()) close_overruns();
    if (flow_.active()) {
      flow_.close_blocked(blocked_);
      if (blocked_.size != 0) suspects_ |= suspect(tables::FindingKind::part_blocked);
    }
    malfunctions_.close();
  }
  const bool unfinished = close_operations();
  reported_any_ = false;
  if (suspects_ != 0) report_findings();
  if (unfinished) {
    for (const WordChange& change : operation_changes_.view()) finish_operations(change);
  }
  finish_units();
  if (first_) [[unlikely]] {
    first_ = false;
    if (observer_ != nullptr) changed_events = report_start();
  }
  if (observer_ != nullptr &&
      (static_cast<std::uint32_t>(reported_any_ || malfunctions_.pending()) | touched_.size | operation_changes_.size |
       static_cast<std::uint32_t>(changed_events.size()) | operation_slot_changes_.size | event_slot_changes_.size |
       static_cast<std::uint32_t>(flow_.changes().size() | flow_.moved_tracks().size())) != 0) {
    observer_->instant({head_->now, touched_.view(), operation_changes_.view(), changed_events,
                        operation_slot_changes_.view(), event_slot_changes_.view(), flow_.changes(),
                        flow_.moved_tracks(), malfunctions_.changes()});
  }
  event_changes_.next_instant();
  touched_.size = operation_changes_.size = 0;
  operation_slot_changes_.size = event_slot_changes_.size = 0;
  flow_.forget_changes();
  malfunctions_.forget_changes();
}

}  // namespace symplant::engine

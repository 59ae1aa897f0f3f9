// Closes an instant: what has changed, requirements, overruns, findings in the order of docs/model.md.
#include <algorithm>
#include <array>
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
       static_cast<std::uint32_t>(flow_.changes().size() | flow_.moved_tracks().size()) |
       static_cast<std::uint32_t>(values_.has_changes())) != 0) {
    observer_->instant({head_->now, touched_.view(), operation_changes_.view(), changed_events,
                        operation_slot_changes_.view(), event_slot_changes_.view(), flow_.changes(),
                        flow_.moved_tracks(), malfunctions_.changes(), values_.take_shown()});
  }
  event_changes_.next_instant();
  touched_.size = operation_changes_.size = 0;
  operation_slot_changes_.size = event_slot_changes_.size = 0;
  flow_.forget_changes();
  malfunctions_.forget_changes();
  if (values_.active()) values_.forget_changes();
}

/// Called only if there may be a finding (suspects_). Each suspected kind is checked, and only real findings are
/// reported.
void Engine::report_findings() noexcept {
  const std::uint32_t suspects = suspects_;
  suspects_ = 0;
  const auto suspected = [&](tables::FindingKind kind) { return (suspects & suspect(kind)) != 0; };
  if (suspected(tables::FindingKind::conflicting_operations)) report_units(tables::FindingKind::conflicting_operations);
  if (suspected(tables::FindingKind::stopped_under_another_command))
    report_units(tables::FindingKind::stopped_under_another_command);
  if (suspected(tables::FindingKind::command_without_effect)) {
    report_operations(tables::FindingKind::command_to_a_disabled_unit);
    report_operations(tables::FindingKind::command_without_effect);
  }
  if (suspected(tables::FindingKind::overrun)) report_all(overrun_, tables::FindingKind::overrun);
  if (suspected(tables::FindingKind::lost_command)) report_operations(tables::FindingKind::lost_command);
  if (suspected(tables::FindingKind::started_on_enabling)) report_units(tables::FindingKind::started_on_enabling);
  if (suspected(tables::FindingKind::event_too_short)) report_short_events();
  if (suspected(tables::FindingKind::instantaneous_loop)) report_loops();
  if (suspected(tables::FindingKind::requirement_violated)) {
    report_all(violated_, tables::FindingKind::requirement_violated);
  }
  if (suspected(tables::FindingKind::part_blocked)) report_all(blocked_, tables::FindingKind::part_blocked);
  if (suspected(tables::FindingKind::value_not_finite)) {
    values_.for_not_finite([this](std::uint32_t value) { marks_.mark(value); });
    report_marked(tables::FindingKind::value_not_finite);
  }
  if ((suspects & kMalfunctionsChanged) != 0) reported_any_ = true;
}

void Engine::report(tables::FindingKind kind, std::uint32_t of, bool more) noexcept {
  const tables::Finding finding{head_->now, of, kind, more};
  findings_.add(finding);
  reported_any_ = true;
  if (observer_ != nullptr) observer_->finding(finding);
}

void Engine::report_marked(tables::FindingKind kind) noexcept {
  const bool group = kind == tables::FindingKind::instantaneous_loop;
  marks_.take_all([&](std::uint32_t of, bool last) { report(kind, of, group && !last); });
}

void Engine::report_units(tables::FindingKind kind) noexcept {
  for (const std::uint32_t unit : touched_.view()) {
    const std::uint32_t flags = units_[unit].flags;
    bool found = false;
    if (kind == tables::FindingKind::conflicting_operations)
      found = (flags & (kConflict | kConflictReported)) == kConflict;
    if (kind == tables::FindingKind::stopped_under_another_command)
      found = (flags & (kStopped | kStoppedReported)) == kStopped;
    if (kind == tables::FindingKind::started_on_enabling) {
      found = (flags & (kEnabledNow | kMoving | kMidway | kHalted)) == (kEnabledNow | kMoving);
    }
    if (found) marks_.mark(unit);
  }
  report_marked(kind);
}

bool Engine::is_operation_finding(tables::FindingKind kind, std::uint32_t unit, std::uint32_t bit) const noexcept {
  const UnitState& state = units_[unit];
  if ((state.flags & kFrozen) != 0) return false;
  const bool disabled = (state.flags & kDisabled) != 0;
  if (kind == tables::FindingKind::lost_command) return true;
  if (kind == tables::FindingKind::command_to_a_disabled_unit) return disabled;
  if (disabled || (state.flags & kMoving) != 0) return false;
  const tables::UnitRow& row = tables_.units[unit];
  const TypeIndex& type = index_.types[row.type];
  const std::uint64_t mask = std::uint64_t{1} << (bit - row.operation_bit);
  return ((type.at[state.state].leads | type.at[state.state].starts) & mask) == 0;
}

void Engine::report_operations(tables::FindingKind kind) noexcept {
  const bool lost = kind == tables::FindingKind::lost_command;
  for (const WordChange& change : operation_changes_.view()) {
    const std::uint64_t on = operations_.bits[change.word];
    std::uint64_t bits = change.bits & ~operation_words_[change.word].served &
                         (lost ? ~on & ~operation_words_[change.word].reported : on);
    for (; bits != 0; bits &= bits - 1) {
      const std::uint32_t bit = change.word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits));
      const std::uint32_t unit = index_.unit_of_operation[bit];
      if (unit == tables::kNone || !is_operation_finding(kind, unit, bit)) continue;
      if (!lost) operation_words_[change.word].reported |= bit_in_word(bit);
      marks_.mark(index_.symbol_of_operation[bit]);
    }
  }
  report_marked(kind);
}

/// Whether a symbol follows a condition and is frozen. O(log follows).
bool Engine::is_frozen_follow(std::uint32_t symbol) const noexcept {
  const auto row = std::lower_bound(tables_.follows.begin(), tables_.follows.end(), symbol,
                                    [](const tables::FollowRow& a, std::uint32_t b) { return a.symbol < b; });
  if (row == tables_.follows.end() || row->symbol != symbol) return false;
  return follow_states_[row - tables_.follows.begin()].frozen != 0;
}

void Engine::report_short_events() noexcept {
  for (const WordChange& change : short_events_.view()) {
    for (std::uint64_t bits = change.bits; bits != 0; bits &= bits - 1) {
      const std::uint32_t bit = change.word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits));
      const std::uint32_t symbol = index_.symbol_of_event[bit];
      const std::uint32_t unit = tables_.symbols.empty() ? tables::kNone : tables_.symbols[symbol].unit;
      const bool frozen = unit == tables::kNone ? is_frozen_follow(symbol) : (units_[unit].flags & kFrozen) != 0;
      if (!frozen) marks_.mark(symbol);
    }
  }
  short_events_.size = 0;
  report_marked(tables::FindingKind::event_too_short);
}

/// Calls `function(member, loop)` for each that was frozen in this instant, as Finding::of numbers them.
template <class Function>
void Engine::for_frozen_now(Function function) noexcept {
  for (const std::uint32_t unit : touched_.view()) {
    if ((units_[unit].flags & kFrozen) != 0 && units_[unit].steps != 0) function(unit, units_[unit].steps);
  }
  const auto unit_count = static_cast<std::uint32_t>(tables_.units.size());
  for (std::uint32_t f = 0; f < tables_.follows.size(); ++f) {
    if (follow_states_[f].frozen == kFrozenInThisInstant) function(unit_count + f, follow_states_[f].steps);
  }
  if (flow_.active()) flow_.for_frozen_now(unit_count + static_cast<std::uint32_t>(tables_.follows.size()), function);
  malfunctions_.for_frozen_now(tables::first_malfunction_of_loop(tables_), function);
  if (values_.active()) values_.for_frozen_now(tables::first_value_of_loop(tables_), function);
}

/// Reports the loops frozen in this instant, in the order of their first members.
void Engine::report_loops() noexcept {
  std::array<std::uint32_t, 256> first{};  // a loop's number -> its first member in table order
  first.fill(tables::kNone);
  for_frozen_now([&](std::uint32_t member, std::uint8_t loop) { first[loop] = std::min(first[loop], member); });
  for (;;) {
    const auto next = std::min_element(first.begin(), first.end());
    if (*next == tables::kNone) break;
    *next = tables::kNone;
    const auto loop = static_cast<std::uint8_t>(next - first.begin());
    for_frozen_now([&](std::uint32_t member, std::uint8_t its_loop) {
      if (its_loop == loop) marks_.mark(member);
    });
    report_marked(tables::FindingKind::instantaneous_loop);
  }
  loops_ = 0;
  for (const std::uint32_t unit : touched_.view()) {
    if ((units_[unit].flags & kFrozen) != 0) units_[unit].steps = 0;
  }
  for (std::size_t f = 0; f < tables_.follows.size(); ++f) {
    if (follow_states_[f].frozen != 0) follow_states_[f].frozen = kFrozenBefore;
  }
  if (flow_.active()) flow_.close_loops();
  malfunctions_.close_loops();
  if (values_.active()) values_.close_loops();
}

/// Reports the collected units or requirements.
void Engine::report_all(List<std::uint32_t>& collected, tables::FindingKind kind) noexcept {
  for (const std::uint32_t of : collected.view()) marks_.mark(of);
  collected.size = 0;
  report_marked(kind);
}

/// Units that can overrun never take the fast path: whatever changes what they are found by touches them.
void Engine::close_overruns() noexcept {
  for (const std::uint32_t unit : touched_.view()) {
    const std::uint32_t position = index_.overruns.position_of(unit);
    if (position != tables::kNone) close_overrun(unit, position);
  }
}

void Engine::close_overrun(std::uint32_t unit, std::uint32_t position) noexcept {
  const UnitState& state = units_[unit];
  const tables::UnitRow& row = tables_.units[unit];
  const TypeIndex& type = index_.types[row.type];
  OverrunState& overrun = overrun_states_[position];
  tables::Time* const begins = overrun_begins_ + index_.overruns.first_operation(position);
  const bool settled = (state.flags & (kMoving | kHalted)) == 0;
  const std::uint64_t commands = settled ? operations_on(row, type) & type.at[state.state].leads : 0;
  const std::uint64_t kept = overrun.state == state.state ? overrun.commands & commands : 0;
  tables::Time due = tables::kNever;  // when the next of them has lasted long enough
  bool found = false;
  for (std::uint64_t bits = commands; bits != 0; bits &= bits - 1) {
    const auto operation = static_cast<std::uint32_t>(std::countr_zero(bits));
    if ((kept >> operation & 1) == 0) begins[operation] = head_->now;
    const tables::Time end = later(begins[operation], tables_.overruns[position].after);
    if (end <= head_->now) {
      found = true;
    } else {
      due = std::min(due, end);
    }
  }
  overrun.commands = commands;
  overrun.state = state.state;
  if (found && overrun.found == 0) {
    overrun_.add(unit);
    suspects_ |= suspect(tables::FindingKind::overrun);
  }
  overrun.found = found ? 1 : 0;
  set_wheel(wheel_entry_of_overrun(position), due);
}

}  // namespace symplant::engine

// Reports the findings of an instant, in the order of docs/model.md, then by unit, symbol or requirement.
#include <algorithm>
#include <array>
#include <bit>

#include "symplant/engine/engine_inline.hpp"

namespace symplant::engine {

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
}

/// Reports the collected units or requirements.
void Engine::report_all(List<std::uint32_t>& collected, tables::FindingKind kind) noexcept {
  for (const std::uint32_t of : collected.view()) marks_.mark(of);
  collected.size = 0;
  report_marked(kind);
}

}  // namespace symplant::engine

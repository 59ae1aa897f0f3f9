// Findings of an instant, in the order of the table in docs/model.md, then of units, symbols, requirements.
#include <algorithm>
#include <array>
#include <bit>

#include "symplant/core/engine_inline.hpp"

namespace symplant::core {

/// Comes here only where there may be one; what is not is sorted out.
void Engine::tell_findings() noexcept {
  const std::uint32_t suspects = suspects_;
  suspects_ = 0;
  const auto suspected = [&](FindingKind kind) { return (suspects & suspect(kind)) != 0; };
  if (suspected(FindingKind::conflicting_operations)) tell_units(FindingKind::conflicting_operations);
  if (suspected(FindingKind::stopped_under_another_command)) tell_units(FindingKind::stopped_under_another_command);
  if (suspected(FindingKind::command_without_effect)) {
    tell_operations(FindingKind::command_to_a_disabled_unit);
    tell_operations(FindingKind::command_without_effect);
  }
  if (suspected(FindingKind::lost_command)) tell_operations(FindingKind::lost_command);
  if (suspected(FindingKind::started_on_enabling)) tell_units(FindingKind::started_on_enabling);
  if (suspected(FindingKind::event_too_short)) tell_short_events();
  if (suspected(FindingKind::instantaneous_loop)) tell_loops();
  if (suspected(FindingKind::requirement_violated)) tell_requirements();
}

void Engine::tell(FindingKind kind, std::uint32_t of, bool more) noexcept {
  const Finding finding{head->now, of, kind, more};
  findings.add(finding);
  told_any_ = true;
  if (observer_ != nullptr) observer_->finding(finding);
}

void Engine::tell_marked(FindingKind kind) noexcept {
  const bool group = kind == FindingKind::instantaneous_loop;
  marks_.take_all([&](std::uint32_t of, bool last) { tell(kind, of, group && !last); });
}

void Engine::tell_units(FindingKind kind) noexcept {
  for (const std::uint32_t unit : touched_.view()) {
    const std::uint32_t flags = units[unit].flags;
    bool found = false;
    if (kind == FindingKind::conflicting_operations) found = (flags & (kConflict | kConflictTold)) == kConflict;
    if (kind == FindingKind::stopped_under_another_command) found = (flags & (kStopped | kStoppedTold)) == kStopped;
    if (kind == FindingKind::started_on_enabling) {
      found = (flags & (kEnabledNow | kMoving | kStanding | kHalted)) == (kEnabledNow | kMoving);
    }
    if (found) marks_.mark(unit);
  }
  tell_marked(kind);
}

bool Engine::is_operation_finding(FindingKind kind, std::uint32_t unit, std::uint32_t bit) const noexcept {
  const UnitState& state = units[unit];
  if ((state.flags & kFrozen) != 0) return false;
  const bool disabled = (state.flags & kDisabled) != 0;
  if (kind == FindingKind::lost_command) return true;
  if (kind == FindingKind::command_to_a_disabled_unit) return disabled;
  if (disabled || (state.flags & kMoving) != 0) return false;
  const UnitRow& row = tables.units[unit];
  const TypeIndex& type = index.types[row.type];
  const std::uint64_t mask = std::uint64_t{1} << (bit - row.operation_bit);
  return ((type.leads[state.state] | type.starts[state.state]) & mask) == 0;
}

void Engine::tell_operations(FindingKind kind) noexcept {
  const bool lost = kind == FindingKind::lost_command;
  for (const WordChange& change : operation_changes_.view()) {
    const std::uint64_t on = operations.bits[change.word];
    std::uint64_t bits = change.bits & ~served[change.word] & (lost ? ~on & ~told[change.word] : on);
    for (; bits != 0; bits &= bits - 1) {
      const std::uint32_t bit = change.word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits));
      const std::uint32_t unit = index.unit_of_operation[bit];
      if (unit == kNoUnit || !is_operation_finding(kind, unit, bit)) continue;
      if (!lost) told[change.word] |= bit_in_word(bit);
      marks_.mark(index.symbol_of_operation[bit]);
    }
  }
  tell_marked(kind);
}

void Engine::tell_short_events() noexcept {
  for (const WordChange& change : short_events_.view()) {
    for (std::uint64_t bits = change.bits; bits != 0; bits &= bits - 1) {
      const std::uint32_t bit = change.word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits));
      const std::uint32_t symbol = index.symbol_of_event[bit];
      const std::uint32_t unit = tables.symbols.empty() ? kNoUnit : tables.symbols[symbol].unit;
      if (unit == kNoUnit || (units[unit].flags & kFrozen) == 0) marks_.mark(symbol);
    }
  }
  short_events_.size = 0;
  tell_marked(FindingKind::event_too_short);
}

/// Loops frozen in this instant stand in the order of their first units.
void Engine::tell_loops() noexcept {
  std::array<std::uint32_t, 256> first{};  // a loop's number -> its first unit
  first.fill(kNoUnit);
  for (const std::uint32_t unit : touched_.view()) {
    if ((units[unit].flags & kFrozenNow) != 0) first[units[unit].steps] = std::min(first[units[unit].steps], unit);
  }
  for (;;) {
    const auto next = std::min_element(first.begin(), first.end());
    if (*next == kNoUnit) break;
    *next = kNoUnit;
    const auto loop = static_cast<std::uint8_t>(next - first.begin());
    for (const std::uint32_t unit : touched_.view()) {
      if ((units[unit].flags & kFrozenNow) != 0 && units[unit].steps == loop) marks_.mark(unit);
    }
    tell_marked(FindingKind::instantaneous_loop);
  }
  loops_ = 0;
}

void Engine::tell_requirements() noexcept {
  for (const std::uint32_t requirement : violated_.view()) marks_.mark(requirement);
  violated_.size = 0;
  tell_marked(FindingKind::requirement_violated);
}

}  // namespace symplant::core

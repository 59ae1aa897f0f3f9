// Commands against the end of a held unit: how long they last, and since when.
#include <algorithm>
#include <bit>

#include "symplant/engine/engine_inline.hpp"

namespace symplant::engine {

/// The unit was on a move at the end of an instant: what it counts as it settles begins anew.
void Engine::forget_overrun(std::uint32_t unit) noexcept {
  const std::uint32_t position = index_.overruns.position_of(unit);
  if (position != tables::kNone) overrun_states_[position].commands = 0;
}

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
  tables::Time first = tables::kNever;
  for (std::uint64_t bits = commands; bits != 0; bits &= bits - 1) {
    const auto operation = static_cast<std::uint32_t>(std::countr_zero(bits));
    if ((kept >> operation & 1) == 0) begins[operation] = head_->now;
    first = std::min(first, begins[operation]);
  }
  overrun.commands = commands;
  overrun.state = state.state;
  const tables::Time due = commands == 0 ? tables::kNever : later(first, tables_.overruns[position].after);
  const bool found = due <= head_->now && commands != 0;
  if (found && overrun.found == 0) {
    overrun_.add(unit);
    suspects_ |= suspect(tables::FindingKind::overrun);
  }
  overrun.found = found ? 1 : 0;
  const std::uint32_t entry = wheel_entry_of_overrun(position);
  set_wheel(entry, found ? tables::kNever : due);
}

}  // namespace symplant::engine

// Commands against the end of a held unit: how long they last, and since when.
#include <algorithm>
#include <bit>

#include "symplant/engine/engine_inline.hpp"

namespace symplant::engine {

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

// Whether what a finding reported still lasts.
#include "symplant/panel/alarm/lasting.hpp"

#include <algorithm>

#include "symplant/why/needs.hpp"
#include "symplant/why/recorded_view.hpp"

namespace symplant::panel {

using tables::FindingKind;

bool Lasting::lasts(FindingKind kind, std::span<const std::uint32_t> about, tables::Time now) {
  const std::uint32_t of = about.front();
  switch (kind) {
    case FindingKind::conflicting_operations:
    case FindingKind::stopped_under_another_command:
    case FindingKind::overrun:
      return of_unit(kind, of);
    case FindingKind::command_to_a_disabled_unit:
      return history_.commands(of) && history_.unit(names_.tables().symbols[of].unit).disabled;
    case FindingKind::command_without_effect:
      return history_.commands(of);
    case FindingKind::instantaneous_loop:
      return std::any_of(about.begin(), about.end(), [this](std::uint32_t member) {
        return member < names_.tables().units.size() && history_.unit(member).frozen;
      });
    case FindingKind::requirement_violated:
      return of_requirement(of, now);
    default:
      return false;
  }
}

bool Lasting::of_unit(FindingKind kind, std::uint32_t unit) const {
  const plant::UnitView view = history_.unit(unit);
  if (kind == FindingKind::stopped_under_another_command) return view.stopped_midway;
  const tables::TypeRow& type = names_.tables().types[names_.tables().units[unit].type];
  std::uint8_t commanded = tables::kNoState;
  bool is_conflict = false;
  std::size_t operation = 0;
  for (const std::uint32_t symbol : names_.symbols_of(unit)) {
    if (!names_.is_operation(symbol)) continue;
    const std::uint8_t target = type.operation_targets[operation++];
    if (target == tables::kNoState || !history_.commands(symbol)) continue;
    is_conflict = is_conflict || (commanded != tables::kNoState && commanded != target);
    commanded = target;
  }
  if (kind == FindingKind::conflicting_operations) return is_conflict;
  return !view.moving && commanded == view.state;
}

bool Lasting::of_requirement(std::uint32_t requirement, tables::Time now) {
  const tables::RequirementRow& row = names_.tables().requirements[requirement];
  const bool is_never = row.kind == tables::RequirementRow::Kind::never;
  const auto [network, added] = networks_.try_emplace(requirement);
  if (added) {
    if (!conditions_) conditions_.emplace(names_.tables());
    network->second = conditions_->network(is_never ? row.condition : row.expected);
  }
  return why::holds(network->second, why::RecordedView(history_, now, nullptr)) == is_never;
}

}  // namespace symplant::panel

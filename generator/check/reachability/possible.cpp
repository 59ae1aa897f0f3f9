// Whether units are moving.
#include "check/reachability/possible.hpp"

#include <algorithm>

namespace symplant::check {

bool travels(const model::Unit& unit) {
  if (unit.has_behaviour() || unit.actuation == tables::Actuation::spring) return true;
  return std::any_of(unit.transitions.begin(), unit.transitions.end(),
                     [](const model::Transition& transition) { return !transition.takes.is_zero(); });
}

bool AllStates::moving(std::uint32_t unit) const { return travels(plant_.units[unit]); }

}  // namespace symplant::check

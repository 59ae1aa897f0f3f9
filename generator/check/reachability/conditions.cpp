// The conditions of a plant with their locations in the description.
#include "check/reachability/conditions.hpp"

namespace symplant::check {
namespace {

void add_conditions(const model::Unit& unit, std::vector<WrittenCondition>& found) {
  std::vector<bool> seen(unit.first_input);
  for (const model::Transition& transition : unit.transitions) {
    if (transition.when == model::kNone || seen[transition.when]) continue;
    seen[transition.when] = true;
    found.push_back({&unit, &unit.conditions[transition.when], unit.described->transitions[transition.given].when, true,
                     transition_pointer(unit, transition, "when")});
  }
  for (std::size_t i = unit.first_input; i < unit.conditions.size(); ++i) {
    const auto& [name, text] = unit.described->inputs[i - unit.first_input];
    found.push_back({&unit, &unit.conditions[i], text, false,
                     description::key_pointer(*unit.described, description::DeviceKey::inputs) / name});
  }
}

}  // namespace

std::vector<WrittenCondition> conditions_of(const Subject& subject) {
  const model::PlantModel& plant = subject.plant;
  std::vector<WrittenCondition> found;
  if (!is_described(subject)) return found;
  for (const model::Unit& unit : plant.units) {
    if (!unit.conditions.empty()) add_conditions(unit, found);
  }
  return found;
}

}  // namespace symplant::check

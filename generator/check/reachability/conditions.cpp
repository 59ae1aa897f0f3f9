// The conditions of a plant with their locations in the description.
#include "check/reachability/conditions.hpp"

#include <algorithm>

namespace symplant::check {
namespace {

void add_conditions(const model::Unit& unit, const model::PlantModel& plant, std::vector<WrittenCondition>& found) {
  const auto verdict_of = [&](std::size_t condition) {
    return decide(unit.conditions[condition], plant, AllStates(plant));
  };
  std::vector<bool> seen(unit.first_input);
  const auto add = [&](const model::Transition& transition, std::uint32_t condition, std::string_view key,
                       std::string description::GivenTransition::*text) {
    if (condition == model::kNone || seen[condition]) return;
    seen[condition] = true;
    found.push_back({&unit, &unit.conditions[condition], unit.described->transitions[transition.given].*text,
                     &transition, key, verdict_of(condition)});
  };
  for (const model::Transition& transition : unit.transitions) {
    add(transition, transition.when, "when", &description::GivenTransition::when);
    add(transition, transition.during, "while", &description::GivenTransition::during);
  }
  for (std::size_t i = unit.first_input; i < unit.conditions.size(); ++i) {
    const auto& inputs = unit.described->inputs;  // some may be left out, and they are in any order
    const std::string_view name = unit.input_names[i - unit.first_input];
    const auto given =
        std::find_if(inputs.begin(), inputs.end(), [&](const auto& input) { return input.first == name; });
    found.push_back({&unit, &unit.conditions[i], given->second, nullptr, given->first, verdict_of(i)});
  }
}

}  // namespace

description::Pointer WrittenCondition::pointer() const {
  return transition != nullptr ? transition_pointer(*unit, *transition, key)
                               : description::key_pointer(*unit->described, description::DeviceKey::inputs) / key;
}

std::vector<WrittenCondition> conditions_of(const Subject& subject) {
  const model::PlantModel& plant = subject.plant;
  std::vector<WrittenCondition> found;
  if (!is_described(subject)) return found;
  for (const model::Unit& unit : plant.units) {
    if (!unit.conditions.empty()) add_conditions(unit, plant, found);
  }
  return found;
}

}  // namespace symplant::check

// Runs cases and compares the engine with the reference.
#include "property/compare.hpp"

#include <algorithm>

#include "lower/lower.hpp"
#include "property/run.hpp"

namespace symplant::property {

RunCounts& RunCounts::operator+=(const RunCounts& other) {
  instants += other.instants;
  advances += other.advances;
  saves += other.saves;
  restores += other.restores;
  restores_elsewhere += other.restores_elsewhere;
  resets += other.resets;
  inputs += other.inputs;
  inputs_refused += other.inputs_refused;
  forces += other.forces;
  qualities += other.qualities;
  furthers += other.furthers;
  malfunctions += other.malfunctions;
  values += other.values;
  values_refused += other.values_refused;
  cut_short += other.cut_short;
  too_many_rises += other.too_many_rises;
  return *this;
}

std::optional<Difference> run_case(const model::PlantModel& plant, const tables::PlantTables& tables,
                                   const std::vector<Action>& actions, bool with_behaviours,
                                   reference::Counters& counters, RunCounts& counts) {
  const bool further = std::any_of(actions.begin(), actions.end(),
                                   [](const Action& action) { return action.kind == Action::Kind::further; });
  Run run(plant, tables, with_behaviours, further, counts);
  std::string text = run.reference().difference_from_model();
  if (!text.empty()) return Difference{actions.size(), "the model: " + text};
  std::optional<Difference> difference;
  for (std::size_t i = 0; i < actions.size() && !difference; ++i) {
    text = run.act(actions[i]);
    if (!text.empty()) difference = Difference{i, std::move(text)};
  }
  counters += run.reference().counters;
  return difference;
}

std::optional<Difference> run_case(const Case& the_case, reference::Counters& counters, RunCounts& counts) {
  const model::Derived derived = build(the_case.plant);
  const model::PlantModel& plant = derived.plant;
  if (!runnable(derived)) return std::nullopt;
  const lower::EngineTables tables = lower::lower(plant);
  const tables::PlantTables rows = tables.tables();
  return run_case(plant, rows, the_case.actions, true, counters, counts);
}

}  // namespace symplant::property

// Makes a plan from a plant.
#include "property/files/plan_of_model.hpp"

#include <set>
#include <string_view>
#include <utility>

namespace symplant::property::files {

PlannedPlant plan_of(const model::PlantModel& plant) {
  PlannedPlant plan;
  std::set<std::string_view> names;
  for (const model::Symbol& symbol : plant.symbols) names.insert(symbol.name());
  for (const model::Unit& unit : plant.units) {
    PlannedUnit planned;
    planned.path = std::string(unit.path);
    for (const model::State& state : unit.states) {
      planned.tasks.push_back({state.name, names.contains(planned.path + "_O_" + state.name),
                               names.contains(planned.path + "_I_" + state.name)});
    }
    plan.units.push_back(std::move(planned));
  }
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.unit != model::kNone) continue;
    if (symbol.type == tables::DataType::boolean) {
      plan.spare_bits.emplace_back(symbol.name());
    } else {
      plan.spare_values.push_back({std::string(symbol.name()), {}, false});
    }
  }
  return plan;
}

}  // namespace symplant::property::files

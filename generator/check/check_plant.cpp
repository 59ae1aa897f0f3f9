// Looks a plant model over by every rule.
#include "check/check_plant.hpp"

#include "check/rules.hpp"

namespace symplant::check {

void check_plant(const model::PlantModel& plant, diag::Diagnostics& diagnostics) {
  for (const Rule* rule : kRules) {
    if (rule->check != nullptr) rule->check(*rule, plant, diagnostics);
  }
}

}  // namespace symplant::check

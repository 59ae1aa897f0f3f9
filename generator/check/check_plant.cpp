// Checks a plant model by every rule.
#include "check/check_plant.hpp"

#include <vector>

#include "check/reachability/conditions.hpp"
#include "check/rules.hpp"
#include "check/spelling/device_classes.hpp"

namespace symplant::check {

void check_plant(const model::PlantModel& plant, const model::Evidence& evidence, diag::Diagnostics& diagnostics) {
  const DeviceClasses classes(plant);
  const OverruledNames overruled(plant);
  std::vector<WrittenCondition> conditions;
  const std::vector<bool> named_otherwise = lists_named_otherwise(plant);
  const Subject subject{plant, evidence, classes, overruled, conditions, named_otherwise};
  conditions = conditions_of(subject);
  for (const Rule* rule : kRules) {
    if (rule->check != nullptr) rule->check(*rule, subject, diagnostics);
  }
}

}  // namespace symplant::check

// Looks a plant model over by every rule.
#include "check/check_plant.hpp"

#include "check/rules.hpp"
#include "check/spelling/device_classes.hpp"

namespace symplant::check {

void check_plant(const model::PlantModel& plant, diag::Diagnostics& diagnostics) {
  const DeviceClasses classes(plant);
  const OverruledNames overruled(plant);
  const Subject subject{plant, classes, overruled};
  for (const Rule* rule : kRules) {
    if (rule->check != nullptr) rule->check(*rule, subject, diagnostics);
  }
}

}  // namespace symplant::check

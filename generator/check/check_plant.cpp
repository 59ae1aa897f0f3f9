// Checks a plant model by every rule.
#include "check/check_plant.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "check/reachability/conditions.hpp"
#include "check/rules.hpp"
#include "check/spelling/device_classes.hpp"

namespace symplant::check {
namespace {

/// Whether a rule presumes names of five levels whose tasks are states.
bool is_of_built_in_names(const Rule* rule) {
  constexpr std::array kOfBuiltInNames{
      &kWrongNumberOfLevels, &kEmptyLevel,       &kDirectionNotIo, &kIllegalCharacter, &kNameSlip,
      &kTwoWordsOneState,    &kTaskClaimedTwice, &kOneTaskAlone,   &kShapeLacksSymbol, &kIoNameInMemory,
  };
  return std::find(kOfBuiltInNames.begin(), kOfBuiltInNames.end(), rule) != kOfBuiltInNames.end();
}

/// Whether a rule judges the names of symbols and the devices that follow from them.
bool needs_names(const Rule& rule) {
  const bool by_name = rule.info.id.substr(0, 3) == "SP4" || rule.info.id.substr(0, 3) == "SP5" || &rule == &kNameSlip;
  return by_name && &rule != &kNoDevice;
}

}  // namespace

void check_plant(const model::PlantModel& plant, const model::Evidence& evidence, diag::Diagnostics& diagnostics) {
  const DeviceClasses classes(plant);
  const OverruledNames overruled(plant);
  std::vector<WrittenCondition> conditions;
  const std::vector<bool> named_otherwise = lists_named_otherwise(plant);
  const Subject subject{plant, evidence, classes, overruled, conditions, named_otherwise};
  conditions = conditions_of(subject);
  const bool named_by_rule = std::find(named_otherwise.begin(), named_otherwise.end(), false) != named_otherwise.end();
  for (const Rule* rule : kRules) {
    if (!named_by_rule && needs_names(*rule)) continue;
    if (plant.pairing != nullptr && is_of_built_in_names(rule)) continue;
    if (rule->check != nullptr) rule->check(*rule, subject, diagnostics);
  }
}

}  // namespace symplant::check

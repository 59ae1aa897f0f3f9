// Checks a plant model by every rule.
#include "check/check_plant.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
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
  check_plant(plant, evidence, base::threads_for(plant.symbols.size()), diagnostics);
}

void check_plant(const model::PlantModel& plant, const model::Evidence& evidence, std::size_t threads,
                 diag::Diagnostics& diagnostics) {
  const DeviceClasses classes(plant);
  const OverruledNames overruled(plant);
  std::vector<WrittenCondition> conditions;
  const std::vector<bool> named_otherwise = lists_named_otherwise(plant);
  const Subject subject{plant, evidence, classes, overruled, conditions, named_otherwise};
  conditions = conditions_of(subject);
  const bool named_by_rule = std::find(named_otherwise.begin(), named_otherwise.end(), false) != named_otherwise.end();
  std::array<diag::Diagnostics, kRules.size()> found;
  base::for_each_number(kRules.size(), threads, [&](std::size_t i) {
    const Rule* rule = kRules[i];
    if (!named_by_rule && needs_names(*rule)) return;
    if (plant.pairing != nullptr && is_of_built_in_names(rule)) return;
    if (rule->check != nullptr) rule->check(*rule, subject, found[i]);
  });
  for (diag::Diagnostics& of_rule : found) diagnostics.add(std::move(of_rule));
}

}  // namespace symplant::check

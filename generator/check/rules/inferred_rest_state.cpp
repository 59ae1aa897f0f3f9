// SP501 inferred-rest-state: a device of one task gets a rest state.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kInferredRestStatePage =
    R"(Inference 1. A device has only one task X (`O_RUN` and `I_RUN`, a push button `I_ON`, a lamp `O_GREEN`). It gets a rest state
`NOT_X` without an event, in which it starts. If X has an operation, the device is a `spring`: it returns to rest when the
operation goes off. If plant.json gives it another actuation, it only starts there.
)";

/// What the unit does with it. A description may have said another actuation, rest or initial state.
std::string_view more(const model::Unit& unit) {
  if (!unit.operations.empty() && unit.actuation == tables::Actuation::spring && unit.rest == 0) {
    return " and returns to it like a spring";
  }
  const bool given_actuation = unit.described != nullptr && unit.described->actuation;
  return given_actuation && unit.initial == 0 ? ", in which it starts" : "";
}

void check_inferred_rest_state(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    if (!unit.rest_added) continue;
    diagnostics.add(rule.info, about_model(plant, unit),
                    fmt::format("`{}` has the one task `{}`: it gets the {}state `{}`{} (inference 1)", unit.path,
                                unit.states[1].name, unit.rest == 0 ? "rest " : "", unit.states[0].name, more(unit)),
                    location_of(plant, first_symbol_of(plant, unit)));
  }
}

}  // namespace

const Rule kInferredRestState{{"SP501", "inferred-rest-state", diag::Severity::note,
                               "a device of one task gets a rest state", kInferredRestStatePage},
                              check_inferred_rest_state};

}  // namespace symplant::check

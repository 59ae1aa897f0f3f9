// SP502 inferred-single-solenoid: a device is taken as a single solenoid.
#include <fmt/format.h>

#include <string>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kInferredSingleSolenoidPage =
    R"(Inference 2. A device has two states: X with an operation and an event, Y with an event only and no sequence number (`O_ADV`,
`I_ADV`, `I_RET`). It is taken as a single solenoid: a `spring` that rests in Y and returns there when the operation goes off.
`actuation`, `rest` and `initial` in plant.json override this.
)";

/// What was inferred of actuation, rest and initial state; empty where the description says all of it.
std::string taken_as(const model::Unit& unit) {
  const description::DeviceDescription* given = unit.described;
  const std::string& rest = unit.states[unit.rest].name;
  if (given == nullptr || !given->actuation)
    return fmt::format("is taken as a single solenoid that returns to `{}`", rest);
  if (unit.actuation == tables::Actuation::spring)
    return given->rest ? "" : fmt::format("is taken to rest in `{}`", rest);
  return unit.initial_from == model::InitialFrom::rest_state ? fmt::format("is taken to start in `{}`", rest) : "";
}

void check_inferred_single_solenoid(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    if (!unit.single_solenoid) continue;
    const std::string taken = taken_as(unit);
    if (taken.empty()) continue;
    diagnostics.add(rule.info, about_model(plant, unit),
                    fmt::format("`{}` has an operation only for `{}`: it {} (inference 2)", unit.path,
                                unit.states[unit.states[0].operation == model::kNone ? 1 : 0].name, taken),
                    location_of(plant, first_symbol_of(plant, unit)));
  }
}

}  // namespace

const Rule kInferredSingleSolenoid{{"SP502", "inferred-single-solenoid", diag::Severity::note,
                                    "a device is taken as a single solenoid", kInferredSingleSolenoidPage},
                                   check_inferred_single_solenoid};

}  // namespace symplant::check

// Rules: what the derivation infers.
#include <fmt/format.h>

#include <string>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

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

void check_inferred_sequence(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    for (const model::Transition& transition : unit.transitions) {
      if (transition.origin != model::Origin::inferred) continue;
      const model::State& to = unit.states[transition.to];
      diagnostics.add(rule.info, about_model(plant, unit),
                      fmt::format("`{}` has no operation for `{}`: it goes there automatically from `{}` (inference 3)",
                                  unit.path, to.name, unit.states[transition.from].name),
                      location_of(plant, event_of(plant, unit, to.event)));
    }
  }
}

}  // namespace

const Rule kInferredRestState{
    {"SP501", "inferred-rest-state", diag::Severity::note, "a device of one task gets a rest state",
     R"(Inference 1. A device has only one task X (`O_RUN` and `I_RUN`, a push button `I_ON`, a lamp `O_GREEN`). It gets a rest state
`NOT_X` without an event, in which it starts. If X has an operation, the device is a `spring`: it returns to rest when the
operation goes off. If plant.json gives it another actuation, it only starts there.
)"},
    check_inferred_rest_state};

const Rule kInferredSingleSolenoid{
    {"SP502", "inferred-single-solenoid", diag::Severity::note, "a device is taken as a single solenoid",
     R"(Inference 2. A device has two states: X with an operation and an event, Y with an event only and no sequence number (`O_ADV`,
`I_ADV`, `I_RET`). It is taken as a single solenoid: a `spring` that rests in Y and returns there when the operation goes off.
`actuation`, `rest` and `initial` in plant.json override this.
)"},
    check_inferred_single_solenoid};

const Rule kInferredSequence{
    {"SP503", "inferred-sequence", diag::Severity::note, "a device goes to a numbered state automatically",
     R"(Inference 3. A numbered state of a device has an event and no operation that leads to it (`O_RUN2`, `I_RUN2`, `I_IDLE1`). The
device goes there automatically from the state with the next lower number, to the lowest from the highest: after the default
time (1 s) in RUN2, the device is back in IDLE1.
)"},
    check_inferred_sequence};

}  // namespace symplant::check

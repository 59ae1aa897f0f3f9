// SP503 inferred-sequence: a device goes on to a numbered state by itself.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kInferredSequencePage =
    R"(Inference 3. A numbered state of a device has an event and no operation leading to it (`O_RUN2`, `I_RUN2`, `I_IDLE1`). It is
reached by itself from the state with the next lower number, the lowest from the highest: after RUN2 has lasted the default
time (1 s), the device is back in IDLE1.
)";

void check_inferred_sequence(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const model::Unit& unit : plant.units) {
    for (const model::Transition& transition : unit.transitions) {
      if (transition.origin != model::Origin::inferred) continue;
      const model::State& to = unit.states[transition.to];
      diagnostics.add(rule.info, about_model(plant, unit),
                      fmt::format("`{}` has no operation for `{}`: it goes there by itself from `{}` (inference 3)",
                                  unit.path, to.name, unit.states[transition.from].name),
                      location_of(plant, event_of(plant, unit, to.event)));
    }
  }
}

}  // namespace

const Rule kInferredSequence{{"SP503", "inferred-sequence", diag::Severity::note,
                              "a device goes on to a numbered state by itself", kInferredSequencePage},
                             check_inferred_sequence};

}  // namespace symplant::check

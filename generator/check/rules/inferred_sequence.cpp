// SP503 inferred-sequence: a device goes to a numbered state automatically.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kInferredSequencePage =
    R"(Inference 3. A numbered state of a device has an event and no operation that leads to it (`O_RUN2`, `I_RUN2`, `I_IDLE1`). The
device goes there automatically from the state with the next lower number, to the lowest from the highest: after the default
time (1 s) in RUN2, the device is back in IDLE1.
)";

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

const Rule kInferredSequence{{"SP503", "inferred-sequence", diag::Severity::note,
                              "a device goes to a numbered state automatically", kInferredSequencePage},
                             check_inferred_sequence};

}  // namespace symplant::check

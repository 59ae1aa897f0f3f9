// SP501 inferred-rest-state: a device of one task was given a rest state.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kPage =
    R"(Inference 1. A device has one task X only (`O_RUN` and `I_RUN`, a push button `I_ON`, a lamp `O_GREEN`). It was given a
rest state `NOT_X` without an event, in which it starts. Where X has an operation, the device is a `spring`: it returns to
rest when the operation goes off.
)";

void check_inferred_rest_state(const Rule& rule, const model::PlantModel& plant, diag::Diagnostics& diagnostics) {
  for (const model::Unit& unit : plant.units) {
    if (!unit.rest_added) continue;
    diagnostics.add(rule.info,
                    fmt::format("`{}` has the one task `{}`: it was given the rest state `{}`{} (inference 1)",
                                unit.path, unit.states[1].name, unit.states[0].name,
                                unit.operations.empty() ? "" : " and returns to it like a spring"),
                    place_of(plant, first_symbol_of(plant, unit)));
  }
}

}  // namespace

const Rule kInferredRestState{
    {"SP501", "inferred-rest-state", diag::Severity::note, "a device of one task was given a rest state", kPage},
    check_inferred_rest_state};

}  // namespace symplant::check

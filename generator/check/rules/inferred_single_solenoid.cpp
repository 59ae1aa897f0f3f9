// SP502 inferred-single-solenoid: a device was taken as a single solenoid.
#include <fmt/format.h>

#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kPage =
    R"(Inference 2. A device has two states, X with an operation and an event, Y with an event alone and no sequence number
(`O_ADV`, `I_ADV`, `I_RET`). It was taken as a single solenoid: a `spring` that rests in Y and returns there when the
operation goes off.
)";

void check_inferred_single_solenoid(const Rule& rule, const model::PlantModel& plant, diag::Diagnostics& diagnostics) {
  for (const model::Unit& unit : plant.units) {
    if (!unit.single_solenoid) continue;
    diagnostics.add(
        rule.info,
        fmt::format("`{}` has an operation for `{}` alone: it was taken as a single solenoid that returns to `{}` "
                    "(inference 2)",
                    unit.path, unit.states[1 - unit.rest].name, unit.states[unit.rest].name),
        place_of(plant, first_symbol_of(plant, unit)));
  }
}

}  // namespace

const Rule kInferredSingleSolenoid{
    {"SP502", "inferred-single-solenoid", diag::Severity::note, "a device was taken as a single solenoid", kPage},
    check_inferred_single_solenoid};

}  // namespace symplant::check

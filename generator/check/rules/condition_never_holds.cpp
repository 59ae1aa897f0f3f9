// SP614 condition-never-holds: a condition contradicts itself.
#include <fmt/format.h>

#include "check/reachability/conditions.hpp"
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kConditionNeverHoldsPage =
    R"(A condition of a device cannot hold, whatever the plant does. It wants one device in two states at once (`AGV.P1 and AGV.P2`),
in a state and moving, a number below 3 and above 5, or a fact and its opposite. A device without a transition that takes time
is never moving.

**What the model loses.** A transition with such a `when` never fires, and an input of a behavior is always off.

**How to fix it.** Most often `and` is written for `or`, or the state of another device is meant. Correct the condition.
)";

void check_condition_never_holds(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const WrittenCondition& condition : subject.conditions) {
    if (!condition.verdict.never()) continue;
    diagnostics.add(
        rule.info, about(*condition.unit),
        fmt::format("`{}` can never hold, so that {}: correct it", condition.text,
                    condition.transition != nullptr ? "the transition is never taken" : "this input is always off"),
        described_location(plant, *condition.unit, condition.pointer()));
  }
}

}  // namespace

const Rule kConditionNeverHolds{{"SP614", "condition-never-holds", diag::Severity::warning,
                                 "a condition contradicts itself", kConditionNeverHoldsPage},
                                check_condition_never_holds};

}  // namespace symplant::check

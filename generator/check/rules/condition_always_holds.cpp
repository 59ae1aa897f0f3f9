// SP615 condition-always-holds: a condition always holds.
#include <fmt/format.h>

#include "check/reachability/conditions.hpp"
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kConditionAlwaysHoldsPage =
    R"(A condition of a device holds whatever the plant does: `not AGV.P1 or not AGV.P2`, a number not below 3 or not above 5.

**What the model loses.** The condition has no effect: the transition fires as if it had no `when`, and the input of a behavior
is always on. What the condition should prevent can happen.

**How to fix it.** Most often `or` is written for `and`. Correct the condition, or remove it.
)";

void check_condition_always_holds(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const WrittenCondition& condition : subject.conditions) {
    if (!condition.verdict.always()) continue;
    diagnostics.add(
        rule.info, about(*condition.unit),
        fmt::format("`{}` always holds, so that {}: correct or remove it", condition.text,
                    condition.transition != nullptr ? "it never holds the transition back" : "this input is always on"),
        described_location(plant, *condition.unit, condition.pointer()));
  }
}

}  // namespace

const Rule kConditionAlwaysHolds{
    {"SP615", "condition-always-holds", diag::Severity::warning, "a condition always holds", kConditionAlwaysHoldsPage},
    check_condition_always_holds};

}  // namespace symplant::check

// SP617 condition-not-examined: a condition has too many parts that depend on each other.
#include <fmt/format.h>

#include "check/reachability/conditions.hpp"
#include "check/reachability/decide.hpp"
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kConditionNotExaminedPage =
    R"(Whether a condition can hold, and can fail, is found by trying its parts in all combinations. Parts that have no device,
symbol or number in common are tried one by one, so most conditions are examined whatever their length; parts that have are
tried together in 4096 combinations at most (twelve symbols). This condition has more.

**What the model loses.** Nothing. Only whether the condition can never hold (SP614) or always holds (SP615) is not known, and
it counts as one that may hold.

**How to fix it.** Nothing to do. Who wants to be sure takes the condition apart.
)";

void check_condition_not_examined(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  const AllStates all(plant);
  for (const WrittenCondition& condition : subject.conditions) {
    if (decide(*condition.tree, plant, all).known()) continue;
    diagnostics.add(rule.info, about(*condition.unit),
                    fmt::format("this condition of `{}` has more than {} combinations of parts that depend on each "
                                "other: it was not examined",
                                condition.unit->path, kMostWorlds),
                    described_location(plant, *condition.unit, condition.pointer));
  }
}

}  // namespace

const Rule kConditionNotExamined{
    {"SP617", "condition-not-examined", diag::Severity::note,
     "a condition has too many parts that depend on each other", kConditionNotExaminedPage},
    check_condition_not_examined};

}  // namespace symplant::check

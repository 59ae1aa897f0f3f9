// SP617 condition-not-examined: a condition has too many parts that depend on each other.
#include <fmt/format.h>

#include "check/reachability/conditions.hpp"
#include "check/reachability/decide.hpp"
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kConditionNotExaminedPage =
    R"(The check tries the parts of a condition in all combinations, to find out whether it can hold and can fail. Parts that have no
device, symbol or number in common are tried one by one, so most conditions are examined whatever their length. Parts that have
something in common are tried together, in at most 4096 combinations (twelve symbols). This condition has more.

**What the model loses.** Nothing. It is only unknown whether the condition can never hold (SP614) or always holds (SP615). The
other checks assume that it may hold.

**How to fix it.** Nothing to do. To have the condition examined, divide it into several.
)";

void check_condition_not_examined(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const WrittenCondition& condition : subject.conditions) {
    if (condition.verdict.known()) continue;
    diagnostics.add(rule.info, about(*condition.unit),
                    fmt::format("this condition of `{}` has more than {} combinations of parts that depend on each "
                                "other: it was not examined",
                                condition.unit->path, kMostWorlds),
                    described_location(plant, *condition.unit, condition.pointer()));
  }
}

}  // namespace

const Rule kConditionNotExamined{
    {"SP617", "condition-not-examined", diag::Severity::note,
     "a condition has too many parts that depend on each other", kConditionNotExaminedPage},
    check_condition_not_examined};

}  // namespace symplant::check

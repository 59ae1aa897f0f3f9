// Rules: conditions and requirements of a description.
#include "check/reachability/conditions.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "check/reachability/decide.hpp"
#include "check/reachability/reach.hpp"
#include "check/rules.hpp"

namespace symplant::check {
namespace {

/// What follows from a condition that never, or always, holds.
std::string_view consequence_of(const WrittenCondition& condition, bool never) {
  if (condition.transition == nullptr) return never ? "this input is always off" : "this input is always on";
  if (condition.key == "while") return never ? "the move never ends" : "it never stops the move";
  return never ? "the transition is never taken" : "it never holds the transition back";
}

void report_decided(const Rule& rule, const Subject& subject, const WrittenCondition& condition,
                    diag::Diagnostics& diagnostics) {
  const bool never = condition.verdict.never();
  diagnostics.add(
      rule.info, about(*condition.unit),
      fmt::format("`{}` {}, so that {}: correct {}it", condition.text, never ? "can never hold" : "always holds",
                  consequence_of(condition, never), never ? "" : "or remove "),
      described_location(subject.plant, *condition.unit, condition.pointer()));
}

void check_condition_never_holds(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  for (const WrittenCondition& condition : subject.conditions) {
    if (condition.verdict.never()) report_decided(rule, subject, condition, diagnostics);
  }
}

void check_condition_always_holds(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  for (const WrittenCondition& condition : subject.conditions) {
    if (condition.verdict.always()) report_decided(rule, subject, condition, diagnostics);
  }
}

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

/// What a verdict comes to, and why; empty where the requirement is open.
std::string_view consequence_of_never(const Verdict& verdict) {
  if (verdict.never()) return "it cannot be violated, and tests nothing";
  if (verdict.always()) return "it is violated from the start";
  return "";
}

std::string_view consequence_of_after(const Verdict& verdict) {
  if (verdict.never()) return "it never begins, and tests nothing";
  if (verdict.always()) return "it begins at the start and never again";
  return "";
}

std::string_view consequence_of_expect(const Verdict& verdict) {
  if (verdict.never()) return "it is violated whenever it begins";
  if (verdict.always()) return "it is always met, and tests nothing";
  return "";
}

class Requirements {
 public:
  Requirements(const Rule& rule, const model::PlantModel& plant, diag::Diagnostics& diagnostics)
      : rule_(rule), plant_(plant), diagnostics_(diagnostics), reach_(plant) {}

  void look_at(std::size_t index) {
    const model::Requirement& requirement = plant_.requirements[index];
    const description::GivenRequirement& given = plant_.description->requirements[requirement.given];
    const Verdict first = decide(requirement.condition, plant_, reach_);
    if (requirement.kind == tables::RequirementRow::Kind::never) {
      report(index, "never", given.never, requirement.condition, first, consequence_of_never(first));
      return;
    }
    report(index, "after", given.after, requirement.condition, first, consequence_of_after(first));
    const Verdict expected = decide(requirement.expected, plant_, reach_);
    report(index, "expect", given.expect, requirement.expected, expected, consequence_of_expect(expected));
  }

 private:
  void report(std::size_t index, std::string_view key, const std::string& text, const condition::Tree& tree,
              const Verdict& verdict, std::string_view consequence) {
    if (consequence.empty()) return;
    const bool by_states = verdict.never() && !decide(tree, plant_, AllStates(plant_)).never();
    const std::string& name = plant_.requirements[index].name;
    diagnostics_.add(
        rule_.info, {{{diag::Subject::Kind::requirement, name}}, {}, {}},
        fmt::format("requirement `{}`: `{}` {}{}: {}", name, text, verdict.never() ? "can never hold" : "always holds",
                    by_states ? ", since nothing leads to a state that it names" : "", consequence),
        location_of({}, description::Pointer("/requirements") / std::size_t{plant_.requirements[index].given} / key));
  }

  const Rule& rule_;
  const model::PlantModel& plant_;
  diag::Diagnostics& diagnostics_;
  const Reach reach_;
};

void check_requirement_decided(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  if (plant.requirements.empty() || !is_described(subject)) return;
  Requirements requirements(rule, plant, diagnostics);
  for (std::size_t i = 0; i < plant.requirements.size(); ++i) requirements.look_at(i);
}

}  // namespace

const Rule kConditionNeverHolds{
    {"SP614", "condition-never-holds", diag::Severity::warning, "a condition contradicts itself",
     R"(A condition of a device cannot hold, whatever the plant does. It wants one device in two states at once (`AGV.P1 and AGV.P2`),
in a state and moving, a number below 3 and above 5, or a fact and its opposite. A device without a transition that takes time
is never moving.

**What the model loses.** A transition with such a `when` never fires, a move with such a `while` never ends, and an input of a
behavior is always off.

**How to fix it.** Most often `and` is written for `or`, or the state of another device is meant. Correct the condition.
)"},
    check_condition_never_holds};

const Rule kConditionAlwaysHolds{
    {"SP615", "condition-always-holds", diag::Severity::warning, "a condition always holds",
     R"(A condition of a device holds whatever the plant does: `not AGV.P1 or not AGV.P2`, a number not below 3 or not above 5.

**What the model loses.** The condition has no effect: the transition fires as if it had no `when`, the move never stops, and
the input of a behavior is always on. What the condition should prevent can happen.

**How to fix it.** Most often `or` is written for `and`. Correct the condition, or remove it.
)"},
    check_condition_always_holds};

const Rule kConditionNotExamined{
    {"SP617", "condition-not-examined", diag::Severity::note,
     "a condition has too many parts that depend on each other",
     R"(The check tries the parts of a condition in all combinations, to find out whether it can hold and can fail. Parts that have no
device, symbol or number in common are tried one by one, so most conditions are examined whatever their length. Parts that have
something in common are tried together, in at most 4096 combinations (twelve symbols). This condition has more.

**What the model loses.** Nothing. It is only unknown whether the condition can never hold (SP614) or always holds (SP615). The
other checks assume that it may hold.

**How to fix it.** Nothing to do. To have the condition examined, divide it into several.
)"},
    check_condition_not_examined};

const Rule kRequirementDecided{
    {"SP616", "requirement-decided", diag::Severity::warning, "a requirement is met or violated whatever the PLC does",
     R"(The outcome of a requirement is known before the plant runs. What it forbids (`never`) or begins with (`after`) can never hold,
because it contradicts itself or names a state that nothing leads to. Or what it expects can never hold, or one of its
conditions always holds.

**What the model loses.** A requirement that cannot fail looks like a passed test and tests nothing. One that cannot be met
fails in every run.

**How to fix it.** Correct the condition, or add the transitions that the devices lack; `unreachable-state` (SP610) names them.
If only a scenario causes what is forbidden, ignore this finding in plant.json with a `why`.
)"},
    check_requirement_decided};

}  // namespace symplant::check

// SP616 requirement-decided: a requirement is met or violated whatever the PLC does.
#include <fmt/format.h>

#include "check/reachability/reach.hpp"
#include "check/rules.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kRequirementDecidedPage =
    R"(The outcome of a requirement is known before the plant runs. What it forbids (`never`) or begins with (`after`) can never hold,
because it contradicts itself or names a state that nothing leads to. Or what it expects can never hold, or one of its
conditions always holds.

**What the model loses.** A requirement that cannot fail looks like a passed test and tests nothing. One that cannot be met
fails in every run.

**How to fix it.** Correct the condition, or add the transitions that the devices lack; `unreachable-state` (SP610) names them.
If only a scenario causes what is forbidden, ignore this finding in plant.json with a `why`.
)";

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

const Rule kRequirementDecided{{"SP616", "requirement-decided", diag::Severity::warning,
                                "a requirement is met or violated whatever the PLC does", kRequirementDecidedPage},
                               check_requirement_decided};

}  // namespace symplant::check

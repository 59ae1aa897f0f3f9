// Reports expectations and requirements as JUnit XML.
#include "symplant/host/junit.hpp"

#include <fmt/format.h>

#include "symplant/trace/finding_words.hpp"
#include "symplant/trace/junit_xml.hpp"

namespace symplant::host {
namespace {

using trace::TestCase;

/// Whether a step is a test case: each expectation, and what was refused or not reached of the other steps.
bool is_case(const scenario::Step& step, const scenario::Outcome& outcome) {
  return step.expect || (step.is_checked() && outcome.kind != scenario::Outcome::Kind::held);
}

/// What a step needs to hold.
std::string_view verb_of(const scenario::Step& step) {
  if (!step.expect) return "needs";
  return step.when == scenario::Step::When::wait ? "wait" : "expect";
}

/// " (10 turns)" for a repeated step.
std::string turns_text(const scenario::Scenario& scenario, std::size_t step) {
  const std::uint64_t turns = scenario::executions(scenario, step);
  return turns == 1 ? "" : fmt::format(" ({} turns)", turns);
}

std::vector<TestCase> cases_of(const trace::PlantNames& names, const scenario::Scenario* scenario,
                               std::span<const scenario::Outcome> outcomes, const Report& report, bool findings,
                               tables::Time end) {
  std::vector<TestCase> cases;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const scenario::Step& step = scenario->steps[i];
    if (!is_case(step, outcomes[i])) continue;
    TestCase test{fmt::format("step {}: {} {}", i + 1, verb_of(step),
                              scenario::expectation_words(step, names) + turns_text(*scenario, i)),
                  outcomes[i].time,
                  {}};
    if (outcomes[i].kind != scenario::Outcome::Kind::held) {
      test.failure = report.failure(i).empty() ? "failed" : report.failure(i);
    }
    cases.push_back(std::move(test));
  }
  for (std::uint32_t r = 0; r < names.tables().requirements.size(); ++r) {
    const Violation& violation = report.violation(r);
    TestCase test{fmt::format("requirement: {}", names.requirement(r)), end, {}};
    if (violation.count != 0) {
      test.time = violation.first;
      test.failure =
          fmt::format("{} {}: {}", violation.count == 1 ? "at" : fmt::format("{} times, first at", violation.count),
                      trace::seconds(violation.first), violation.words);
    }
    cases.push_back(std::move(test));
  }
  if (findings) {
    TestCase test{"findings", end, {}};
    if (report.findings() != 0) test.failure = fmt::format("{} findings", report.findings());
    cases.push_back(std::move(test));
  }
  return cases;
}

}  // namespace

std::string junit_text(const plant::Plant& plant, const trace::PlantNames& names, const scenario::Scenario* scenario,
                       std::span<const scenario::Outcome> outcomes, const Report& report, bool fail_on_findings) {
  return trace::junit_xml(names.tables().name,
                          cases_of(names, scenario, outcomes, report, fail_on_findings, plant.now()), plant.now());
}

}  // namespace symplant::host

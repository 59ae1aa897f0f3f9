// Writes the results of a run as JUnit XML: expectations, requirements, findings, and whether its PLCs took part.
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

void add_steps(const JUnitInput& input, std::vector<TestCase>& cases) {
  for (std::size_t i = 0; i < input.outcomes.size(); ++i) {
    const scenario::Step& step = input.scenario->steps[i];
    if (!is_case(step, input.outcomes[i])) continue;
    TestCase test{fmt::format("step {}: {} {}", i + 1, verb_of(step),
                              scenario::expectation_words(step, input.names) + turns_text(*input.scenario, i)),
                  input.outcomes[i].time,
                  {},
                  {}};
    if (input.outcomes[i].kind != scenario::Outcome::Kind::held) {
      test.failure = input.report.failure(i).empty() ? "failed" : input.report.failure(i);
    }
    cases.push_back(std::move(test));
  }
}

void add_requirements(const JUnitInput& input, std::vector<TestCase>& cases) {
  for (std::uint32_t r = 0; r < input.names.tables().requirements.size(); ++r) {
    const Violation& violation = input.report.violation(r);
    TestCase test{fmt::format("requirement: {}", input.names.requirement(r)), input.plant.now(), {}, {}};
    if (violation.count != 0) {
      test.time = violation.first;
      test.failure =
          fmt::format("{} {}: {}", violation.count == 1 ? "at" : fmt::format("{} times, first at", violation.count),
                      trace::seconds(violation.first), violation.words);
    }
    cases.push_back(std::move(test));
  }
}

void add_run(const JUnitInput& input, std::vector<TestCase>& cases) {
  const tables::Time end = input.plant.now();
  if (input.plcs != nullptr) {
    cases.push_back({"no PLC", end, input.report.words(tables::FindingKind::no_plc), {}});
    cases.push_back({"plant time", end, input.plcs->stalled, {}});
  }
  if (input.fail_on_findings) {
    const std::uint64_t findings = input.report.findings();
    cases.push_back({"findings", end, findings == 0 ? "" : fmt::format("{} findings", findings), {}});
  }
  if (input.clean)
    cases.push_back({"rt-check", end, *input.clean ? "" : "a cycle broke the rule, or was not checked", {}});
  if (!input.error.empty()) cases.push_back({"run", end, {}, input.error});
}

}  // namespace

std::string junit_text(const JUnitInput& input) {
  std::vector<TestCase> cases;
  add_steps(input, cases);
  add_requirements(input, cases);
  add_run(input, cases);
  return trace::junit_xml(input.names.tables().name, cases, input.plant.now());
}

}  // namespace symplant::host

// Findings as JUnit XML.
#include "diag/junit.hpp"

#include "support/catch.hpp"
#include "support/findings.hpp"
#include "support/strings.hpp"

using namespace symplant;
using test::about;
using test::contains;

namespace {

constexpr diag::RuleInfo kNames{"SP201", "wrong-number-of-levels", diag::Severity::warning, "", ""};
constexpr diag::RuleInfo kRest{"SP501", "inferred-rest-state", diag::Severity::note, "", ""};
constexpr diag::RuleInfo kTwice{"SP302", "symbol-declared-differently", diag::Severity::error, "", ""};

std::vector<diag::Report> one_plant(bool readable = true) {
  const auto source = std::make_shared<const text::SourceFile>("list.csv", "A<B,X1\nSTART,X2\n");
  diag::Diagnostics findings;
  findings.add(kNames, about({"A<B"}), "say `A<B`", {source, {0, 3}});
  findings.add(kNames, about({"START"}), "say more", {source, {7, 12}});
  findings.add(kNames, about({"START"}), "say it again", {source, {7, 12}});
  findings.add(kRest, about({"L_P_D"}), "given", {source, {7, 12}});
  findings.ignore({&kTwice, diag::Severity::error, "hidden", {source, {0, 1}}, {}, about({"A"})},
                  "wired \"next\" year");
  std::vector<diag::Report> reports;
  reports.push_back({"line1/list.csv", std::move(findings), readable});
  return reports;
}

std::string junit(const std::vector<diag::Report>& reports, diag::Severity fail_on) {
  return diag::render_junit(reports, {fail_on, {&kNames, &kTwice, &kRest}});
}

}  // namespace

TEST_CASE("JUnit: Each failing finding is a test of its rule, lesser ones are output of a passing test") {
  CHECK(junit(one_plant(), diag::Severity::warning) ==
        R"xml(<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="symplant check" tests="6" failures="3" errors="0" skipped="1" time="0">
  <testsuite name="line1/list.csv" tests="6" failures="3" errors="0" skipped="1" time="0">
    <testcase classname="line1/list.csv.SP201 wrong-number-of-levels" name="A&lt;B" time="0" file="list.csv">
      <failure type="warning" message="say `A&lt;B`">list.csv:1:1: warning: say `A&lt;B` [SP201 wrong-number-of-levels]
    1 | A&lt;B,X1
      | ^~~
</failure>
    </testcase>
    <testcase classname="line1/list.csv.SP201 wrong-number-of-levels" name="START" time="0" file="list.csv">
      <failure type="warning" message="say more">list.csv:2:1: warning: say more [SP201 wrong-number-of-levels]
    2 | START,X2
      | ^~~~~
</failure>
    </testcase>
    <testcase classname="line1/list.csv.SP201 wrong-number-of-levels" name="START (2)" time="0" file="list.csv">
      <failure type="warning" message="say it again">list.csv:2:1: warning: say it again [SP201 wrong-number-of-levels]
    2 | START,X2
      | ^~~~~
</failure>
    </testcase>
    <testcase classname="line1/list.csv.SP302 symbol-declared-differently" name="A" time="0" file="list.csv">
      <skipped message="ignored by plant.json: wired &quot;next&quot; year"/>
    </testcase>
    <testcase classname="line1/list.csv.SP302 symbol-declared-differently" name="nothing that fails" time="0"/>
    <testcase classname="line1/list.csv.SP501 inferred-rest-state" name="nothing that fails" time="0">
      <system-out>list.csv:2:1: note: given [SP501 inferred-rest-state]
    2 | START,X2
      | ^~~~~
</system-out>
    </testcase>
  </testsuite>
</testsuites>
)xml");
}

TEST_CASE("JUnit: Failures follow --fail-on") {
  CHECK(contains(junit(one_plant(), diag::Severity::error), "tests=\"4\" failures=\"0\""));
  CHECK(contains(junit(one_plant(), diag::Severity::note), "tests=\"6\" failures=\"4\""));
}

TEST_CASE("JUnit: An unreadable plant has errors, and no passing test") {
  const std::string text = junit(one_plant(false), diag::Severity::error);
  CHECK(contains(text, "tests=\"5\" failures=\"0\" errors=\"4\" skipped=\"1\""));
  CHECK_FALSE(contains(text, "nothing that fails"));
}

TEST_CASE("JUnit: Each plant is a suite, and the counts are added up") {
  std::vector<diag::Report> reports = one_plant();
  reports.push_back({"line2.json", {}, true});
  const std::string text = junit(reports, diag::Severity::warning);
  CHECK(contains(text, "<testsuites name=\"symplant check\" tests=\"9\" failures=\"3\""));
  CHECK(contains(text, "<testsuite name=\"line2.json\" tests=\"3\" failures=\"0\""));
}

TEST_CASE("JUnit: Each gate of a plant is a test of the plant, which fails with its message") {
  std::vector<diag::Report> reports = one_plant();
  reports[0].gates = {{"min-score a=1", ""}, {"min-score b=1", "2 < 3"}};
  const std::string text = junit(reports, diag::Severity::error);
  CHECK(contains(text, "<testcase classname=\"line1/list.csv\" name=\"min-score a=1\" time=\"0\"/>"));
  CHECK(contains(text, "name=\"min-score b=1\" time=\"0\">\n      <failure message=\"2 &lt; 3\"/>\n    </testcase>\n"));
  CHECK(contains(text, "tests=\"6\" failures=\"1\""));
}

// Findings that a plant has had before.
#include "findings/baseline.hpp"

#include "check/catalogue.hpp"
#include "diag/text.hpp"
#include "support/catch.hpp"
#include "support/strings.hpp"

namespace symplant::findings {
namespace {

constexpr diag::RuleInfo kWarning{"SP401", "operation-without-event", diag::Severity::warning, "", ""};
constexpr diag::RuleInfo kBinding{"SP101", "cannot-read-file", diag::Severity::error, "", ""};

diag::Diagnostic about(const std::string& name, std::string shape = {}, const diag::RuleInfo& rule = kWarning) {
  diag::Diagnostic finding;
  finding.rule = &rule;
  finding.severity = rule.severity;
  finding.message = "`" + name + "` is odd";
  finding.subjects.about.push_back({diag::Subject::Kind::symbol, name});
  finding.subjects.shape = std::move(shape);
  return finding;
}

diag::Diagnostics list(std::vector<diag::Diagnostic> findings) {
  diag::Diagnostics all;
  for (diag::Diagnostic& finding : findings) all.add(std::move(finding));
  return all;
}

std::shared_ptr<const text::SourceFile> file(std::string text) {
  return std::make_shared<text::SourceFile>("baseline.json", std::move(text));
}

Baseline read(const std::string& text) {
  auto baseline = Baseline::read(file(text));
  REQUIRE(baseline);
  return std::move(*baseline);
}

/// The baseline of these findings, written and read again.
Baseline of(const diag::Diagnostics& findings) {
  Baseline first;
  CHECK(first.apply("l.csv", findings).all().empty());
  CHECK(first.size() == findings.all().size());
  return read(first.text());
}

std::string stale(const Baseline& baseline) {
  diag::Diagnostics findings;
  baseline.report_stale(findings);
  return findings.all().empty() ? "" : findings.all().front().message;
}

TEST_CASE("A written baseline leaves out every finding, on whatever rows they are") {
  const diag::Diagnostics before = list({about("A"), about("D1", "D#"), about("D2", "D#")});
  Baseline baseline = of(before);
  const diag::Diagnostics after = baseline.apply("l.csv", list({about("D2", "D#"), about("D7", "D#"), about("A")}));
  CHECK(after.all().empty());
  CHECK(after.left_out().baseline == 3);
  CHECK(after.left_out().total() == 3);
  CHECK(stale(baseline).empty());
}

TEST_CASE("What a baseline does not have is reported: another name, rule, plant, or one more of a shape") {
  const diag::Diagnostics before = list({about("A"), about("D1", "D#"), about("D2", "D#")});
  CHECK(of(before).apply("l.csv", list({about("B")})).all().size() == 1);
  CHECK(of(before).apply("l.csv", list({about("A", "", *check::find_rule("SP626"))})).all().size() == 1);
  CHECK(of(before).apply("other.csv", list({about("A")})).all().size() == 1);
  const diag::Diagnostics three = list({about("D1", "D#"), about("D2", "D#"), about("D3", "D#")});
  CHECK(of(before).apply("l.csv", three).all().size() == 3);
}

TEST_CASE("An error that leaves no valid plant is in no baseline") {
  Baseline first;
  CHECK(first.apply("l.csv", list({about("A", "", kBinding)})).all().size() == 1);
  CHECK(first.size() == 0);
  CHECK(first.text() == "{\n  \"symplant-baseline\": 1,\n  \"findings\": []\n}\n");
}

TEST_CASE("What is fixed makes the baseline stale, and is left out when it is written again") {
  Baseline baseline = of(list({about("A"), about("D1", "D#"), about("D2", "D#")}));
  CHECK(baseline.apply("l.csv", list({about("D1", "D#"), about("NEW")})).all().size() == 1);
  CHECK(stale(baseline) ==
        "2 findings of the baseline are no longer there, such as SP401 of `A` in l.csv: run the same command with "
        "`--write-baseline` to remove them");
  CHECK(baseline.size() == 1);
  CHECK(baseline.text() ==
        "{\n  \"symplant-baseline\": 1,\n  \"findings\": [\n"
        "    {\"plant\":\"l.csv\",\"rule\":\"SP401\",\"of\":\"D#\",\"count\":1}\n  ]\n}\n");
}

TEST_CASE("A file that is no baseline is refused with its location") {
  const auto fault = [](const std::string& text) {
    const auto baseline = Baseline::read(file(text));
    REQUIRE_FALSE(baseline);
    return diag::render_text(baseline.error().all());
  };
  using test::contains;
  CHECK(contains(fault("{"), "baseline.json:1:1: error:"));
  CHECK(contains(fault("[]"), "baseline.json:1:1: error:"));
  CHECK(contains(fault(R"({"symplant-baseline": 2, "findings": []})"), "baseline.json:1:23: error:"));
  const std::string entry = R"({"plant": "l", "rule": "SP401", "of": "A", "count": )";
  CHECK(contains(fault("{\"symplant-baseline\": 1, \"findings\": [\n" + entry + "0}]}"), "baseline.json:2:53: error:"));
  CHECK(Baseline::read(file("{\"symplant-baseline\": 1, \"findings\": [" + entry + "1}]}")));
}

}  // namespace
}  // namespace symplant::findings

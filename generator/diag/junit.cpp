// Findings as JUnit XML.
#include "diag/junit.hpp"

#include <cstddef>
#include <map>

#include "diag/encode.hpp"
#include "diag/text.hpp"

namespace symplant::diag {
namespace {

struct Counts {
  std::size_t tests = 0;
  std::size_t failures = 0;
  std::size_t errors = 0;
  std::size_t skipped = 0;

  void add(const Counts& more) {
    tests += more.tests;
    failures += more.failures;
    errors += more.errors;
    skipped += more.skipped;
  }
  std::string attributes() const {
    return " tests=\"" + std::to_string(tests) + "\" failures=\"" + std::to_string(failures) + "\" errors=\"" +
           std::to_string(errors) + "\" skipped=\"" + std::to_string(skipped) + "\" time=\"0\"";
  }
};

/// Findings as text, with their line ends.
std::string body_of(std::span<const Diagnostic> findings) {
  std::string body;
  const std::string text = render_text(findings, {.all = true});
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    body += markup_text(std::string_view(text).substr(at, end - at)) + "\n";
    at = end + 1;
  }
  return body;
}

class SuiteRenderer {
 public:
  SuiteRenderer(const Report& report, const JunitOptions& options) : report_(report), options_(options) {}

  std::string render() {
    std::map<const RuleInfo*, std::vector<Diagnostic>> lesser;  // never iterated
    std::map<const RuleInfo*, bool> failing;
    for (const Diagnostic& finding : report_.findings.all()) {
      if (report_.readable && finding.severity < options_.fail_on) {
        lesser[finding.rule].push_back(finding);
      } else {
        failing[finding.rule] = true;
        fail(finding);
      }
    }
    for (const Ignored& each : report_.findings.ignored()) skip(each);
    if (report_.readable) {
      for (const RuleInfo* rule : options_.rules) {
        if (!failing[rule]) pass(*rule, lesser[rule]);
      }
      for (const Gate& gate : report_.gates) test(gate);
    }
    return "  <testsuite name=\"" + markup_text(report_.plant) + "\"" + counts_.attributes() + ">\n" + cases_ +
           "  </testsuite>\n";
  }

  const Counts& counts() const { return counts_; }

 private:
  static std::string rule_name(const RuleInfo& rule) { return std::string(rule.id) + " " + std::string(rule.slug); }

  /// Begins the element of a test case, without its `>`.
  void begin(const RuleInfo& rule, const std::string& name) {
    ++counts_.tests;
    cases_ += "    <testcase classname=\"" + markup_text(report_.plant + "." + rule_name(rule)) + "\" name=\"" +
              markup_text(name) + "\" time=\"0\"";
  }

  void begin(const Diagnostic& finding) {
    std::string name = finding.location.source ? finding.location.source->path() : report_.plant;
    if (!finding.subjects.about.empty()) name = finding.subjects.about.front().name;
    const std::size_t seen = ++seen_[{finding.rule, name}];
    if (seen > 1) name += " (" + std::to_string(seen) + ")";
    begin(*finding.rule, name);
    if (finding.location.source) cases_ += " file=\"" + markup_text(finding.location.source->path()) + "\"";
    cases_ += ">\n";
  }

  void fail(const Diagnostic& finding) {
    begin(finding);
    const std::string element = report_.readable ? "failure" : "error";
    ++(report_.readable ? counts_.failures : counts_.errors);
    cases_ += "      <" + element + " type=\"" + std::string(severity_name(finding.severity)) + "\" message=\"" +
              markup_text(finding.message) + "\">" + body_of({&finding, 1}) + "</" + element + ">\n    </testcase>\n";
  }

  void skip(const Ignored& ignored) {
    begin(ignored.finding);
    ++counts_.skipped;
    cases_ +=
        "      <skipped message=\"" + markup_text("ignored by plant.json: " + ignored.why) + "\"/>\n    </testcase>\n";
  }

  void pass(const RuleInfo& rule, std::span<const Diagnostic> lesser) {
    begin(rule, "nothing that fails");
    if (lesser.empty()) {
      cases_ += "/>\n";
    } else {
      cases_ += ">\n      <system-out>" + body_of(lesser) + "</system-out>\n    </testcase>\n";
    }
  }

  void test(const Gate& gate) {
    ++counts_.tests;
    cases_ += "    <testcase classname=\"" + markup_text(report_.plant) + "\" name=\"" + markup_text(gate.name) +
              "\" time=\"0\"";
    if (gate.failure.empty()) {
      cases_ += "/>\n";
      return;
    }
    ++counts_.failures;
    cases_ += ">\n      <failure message=\"" + markup_text(gate.failure) + "\"/>\n    </testcase>\n";
  }

  const Report& report_;
  const JunitOptions& options_;
  Counts counts_;
  std::map<std::pair<const RuleInfo*, std::string>, std::size_t> seen_;  // never iterated
  std::string cases_;
};

}  // namespace

std::string render_junit(std::span<const Report> reports, const JunitOptions& options) {
  Counts counts;
  std::string suites;
  for (const Report& report : reports) {
    SuiteRenderer suite(report, options);
    suites += suite.render();
    counts.add(suite.counts());
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"symplant check\"" + counts.attributes() +
         ">\n" + suites + "</testsuites>\n";
}

}  // namespace symplant::diag

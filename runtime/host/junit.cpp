// Reports expectations and requirements as JUnit XML.
#include "symplant/host/junit.hpp"

#include <fmt/format.h>

#include "symplant/trace/finding_words.hpp"

namespace symplant::host {
namespace {

struct TestCase {
  std::string name;
  tables::Time time = 0;
  std::string failure;  ///< empty: passed
};

/// Plant time in seconds, without the unit, to the nanosecond.
std::string time_text(tables::Time time) {
  const std::string text = trace::seconds(time);
  return text.substr(0, text.find(' '));
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
    if (!step.is_checked()) continue;
    TestCase test{fmt::format("step {}: {} {}", i + 1, step.when == scenario::Step::When::wait ? "wait" : "expect",
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

/// The size in bytes of the first UTF-8 character; 0 if it is invalid or not allowed in XML.
std::size_t xml_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < size) return 0;
  char32_t code = first & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3F);
  }
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code < kLeast[size] || code > 0x10FFFF || surrogate || code == 0xFFFE || code == 0xFFFF ? 0 : size;
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string xml;
  while (!text.empty()) {
    const std::size_t size = xml_character(text);
    const char c = text.front();
    if (size == 0) {
      xml += "\xEF\xBF\xBD";
    } else if (c == '&') {
      xml += "&amp;";
    } else if (c == '<') {
      xml += "&lt;";
    } else if (c == '>') {
      xml += "&gt;";
    } else if (c == '"') {
      xml += "&quot;";
    } else if (c == '\n' || c == '\t' || c == '\r') {  // unescaped, an attribute would turn it into a blank
      xml += fmt::format("&#{};", static_cast<int>(c));
    } else {
      xml += text.substr(0, size);
    }
    text.remove_prefix(size == 0 ? 1 : size);
  }
  return xml;
}

std::string junit_text(const plant::Plant& plant, const trace::PlantNames& names, const scenario::Scenario* scenario,
                       std::span<const scenario::Outcome> outcomes, const Report& report, bool fail_on_findings) {
  const std::vector<TestCase> cases = cases_of(names, scenario, outcomes, report, fail_on_findings, plant.now());
  std::size_t failures = 0;
  std::string lines;
  const std::string suite = xml_text(names.tables().name);
  for (const TestCase& test : cases) {
    lines += fmt::format(R"(    <testcase classname="{}" name="{}" time="{}")", suite, xml_text(test.name),
                         time_text(test.time));
    if (test.failure.empty()) {
      lines += "/>\n";
      continue;
    }
    ++failures;
    lines += fmt::format(">\n      <failure message=\"{}\"/>\n    </testcase>\n", xml_text(test.failure));
  }
  const std::string counts =
      fmt::format(R"(tests="{}" failures="{}" errors="0" time="{}")", cases.size(), failures, time_text(plant.now()));
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {1}>\n  <testsuite name=\"{0}\" {1}>\n{2}"
      "  </testsuite>\n</testsuites>\n",
      suite, counts, lines);
}

}  // namespace symplant::host

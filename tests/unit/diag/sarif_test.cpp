// Findings as SARIF.
#include "diag/sarif.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "diag/encode.hpp"
#include "diag/uri.hpp"
#include "support/catch.hpp"
#include "support/findings.hpp"

using namespace symplant;
using nlohmann::json;
using test::about;

namespace {

constexpr diag::RuleInfo kSarifNames{"SP201", "wrong-number-of-levels", diag::Severity::warning, "a name has levels",
                                     "It has\nothers.\n\nMore of it.\n"};
constexpr diag::RuleInfo kSarifRest{"SP501", "inferred-rest-state", diag::Severity::note, "a rest", "Given.\n"};
constexpr diag::RuleInfo kSarifTwice{"SP302", "symbol-declared-differently", diag::Severity::error, "twice", "Two.\n"};

std::shared_ptr<const text::SourceFile> list(std::string text, std::string path = "line 1/list.csv") {
  return std::make_shared<const text::SourceFile>(std::move(path), std::move(text));
}

/// The first location of a word in a list.
diag::Location at(const std::shared_ptr<const text::SourceFile>& source, std::string_view word) {
  const std::size_t begin = source->text().find(word);
  return {source, {begin, begin + word.size()}};
}

json run_of(const std::vector<diag::Report>& reports, const diag::SarifOptions& options = {"0.1.0", "/home/ci", 1}) {
  const json log = json::parse(diag::render_sarif(reports, options));
  CHECK(log.at("version") == "2.1.0");
  REQUIRE(log.at("runs").size() == 1);
  return log["runs"][0];
}

/// Fingerprints of a run, by message.
std::vector<std::string> fingerprints(const std::vector<diag::Report>& reports) {
  std::vector<std::string> all;
  const json run = run_of(reports);
  for (const json& result : run["results"]) {
    all.push_back(result["partialFingerprints"]["symplant/v1"].get<std::string>());
    CHECK(result["partialFingerprints"]["primaryLocationLineHash"] == all.back());
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<diag::Report> report_of(diag::Diagnostics findings) {
  std::vector<diag::Report> reports;
  reports.push_back({"plant.json", std::move(findings)});
  return reports;
}

/// A warning about each of these rows.
std::vector<diag::Report> about_rows(const std::vector<std::string>& rows) {
  std::string text;
  for (const std::string& row : rows) text += row + "\n";
  const auto source = list(text);
  diag::Diagnostics findings;
  std::size_t begin = 0;
  for (const std::string& row : rows) {
    findings.add(kSarifNames, about({row}), "`" + row + "` in row " + std::to_string(begin),
                 {source, {begin, begin + row.size()}});
    begin += row.size() + 1;
  }
  return report_of(std::move(findings));
}

}  // namespace

TEST_CASE("SARIF has rule, level, location and related locations of each finding, with columns in characters") {
  const auto source = list("\xC3\x84\xC3\x96,X1\nAB,X2\n");
  diag::Diagnostics findings;
  findings.add(kSarifNames, about({"AB"}), "say `AB`", at(source, "AB"), {{at(source, "X1"), "first"}});
  const json run = run_of(report_of(std::move(findings)));
  const json& result = run["results"][0];
  CHECK(result["ruleId"] == "SP201");
  CHECK(result["ruleIndex"] == 0);
  CHECK(result["level"] == "warning");
  CHECK(result["message"]["text"] == "say `AB`");
  CHECK(result["locations"] == json::parse(R"([{"physicalLocation": {
    "artifactLocation": {"uri": "line%201/list.csv", "uriBaseId": "%SRCROOT%"},
    "region": {"startLine": 2, "startColumn": 1, "endLine": 2, "endColumn": 3, "snippet": {"text": "AB"}}}}])"));
  CHECK(result["relatedLocations"][0]["message"]["text"] == "first");
  CHECK(result["relatedLocations"][0]["physicalLocation"]["region"]["startColumn"] == 4);
  CHECK_FALSE(result.contains("suppressions"));
  CHECK(run["columnKind"] == "unicodeCodePoints");
  CHECK(run["invocations"][0] == json::parse(R"({"executionSuccessful": true, "exitCode": 1})"));
}

TEST_CASE("SARIF describes the rules that have results, with their manual pages") {
  diag::Diagnostics findings;
  findings.add(kSarifRest, "given", {});
  findings.add(kSarifNames, "named", {});
  const json run = run_of(report_of(std::move(findings)));
  const json& rules = run["tool"]["driver"]["rules"];
  REQUIRE(rules.size() == 2);
  CHECK(rules[0] == json::parse(R"({"id": "SP201", "name": "wrong-number-of-levels",
    "shortDescription": {"text": "a name has levels"}, "fullDescription": {"text": "It has others."},
    "help": {"text": "It has\nothers.\n\nMore of it.\n", "markdown": "It has\nothers.\n\nMore of it.\n"},
    "defaultConfiguration": {"level": "warning"}})"));
  for (const json& result : run["results"]) {
    CHECK(rules[result["ruleIndex"].get<std::size_t>()]["id"] == result["ruleId"]);
  }
}

TEST_CASE("SARIF lists errors first, and findings ignored by plant.json last, with their reason") {
  const auto source = list("A\n");
  diag::Diagnostics findings;
  findings.add(kSarifRest, about({"A"}), "note", at(source, "A"));
  findings.add(kSarifTwice, about({"A"}), "error", at(source, "A"));
  findings.ignore({&kSarifTwice, diag::Severity::error, "hidden", at(source, "A"), {}, about({"A"})},
                  "wired next year");
  const json run = run_of(report_of(std::move(findings)));
  const json& results = run["results"];
  REQUIRE(results.size() == 3);
  CHECK(results[0]["message"]["text"] == "error");
  CHECK(results[1]["message"]["text"] == "note");
  CHECK(results[2]["suppressions"] ==
        json::parse(R"([{"kind": "external", "status": "accepted", "justification": "wired next year"}])"));
}

TEST_CASE("SARIF gives a finding without a location its plant's first line, which build servers need") {
  diag::Diagnostics findings;
  findings.add(kSarifTwice, "nowhere", {});
  findings.add(kSarifTwice, "empty", {list("", "/home/ci/sub/empty.csv"), {}});
  findings.add(kSarifTwice, "elsewhere", {list("", "/srv/empty.csv"), {}});
  const json run = run_of(report_of(std::move(findings)), {"0.1.0", "/home/ci", 2});
  const auto location = [&](std::size_t i) { return run["results"][i]["locations"][0]["physicalLocation"]; };
  CHECK(location(0)["artifactLocation"]["uri"] == "plant.json");
  CHECK(location(0)["region"] == json::parse(R"({"startLine": 1})"));
  CHECK(location(1)["artifactLocation"]["uri"] == "sub/empty.csv");
  CHECK(location(2)["artifactLocation"] == json::parse(R"({"uri": "file:///srv/empty.csv"})"));
  CHECK(run["invocations"][0]["executionSuccessful"] == false);
}

TEST_CASE("Fingerprints stay the same when rows move, are shuffled, or are inserted") {
  const auto before = fingerprints(about_rows({"A", "B", "C", "A"}));
  CHECK(fingerprints(about_rows({"C", "A", "A", "B"})) == before);
  const auto more = fingerprints(about_rows({"NEW", "B", "A", "C", "A"}));
  CHECK(std::includes(more.begin(), more.end(), before.begin(), before.end()));
  CHECK(fingerprints(about_rows({"a", "B", "C", "a"})) == before);  // names are compared ignoring case
}

TEST_CASE("Fingerprints of different findings differ: by symbol, rule, file, and equal ones by their number") {
  const auto source = list("A,B\n");
  const auto other = list("A,B\n", "other.csv");
  diag::Diagnostics findings;
  findings.add(kSarifNames, about({"A"}), "x", at(source, "A"));
  findings.add(kSarifNames, about({"A"}), "x", at(source, "A"));
  findings.add(kSarifNames, about({"B"}), "x", at(source, "A"));
  findings.add(kSarifNames, about({"A", "B"}), "x", at(source, "A"));
  findings.add(kSarifNames, about({"AB"}), "x", at(source, "A"));
  findings.add(kSarifRest, about({"A"}), "x", at(source, "A"));
  findings.add(kSarifNames, about({"A"}), "x", at(other, "A"));
  findings.add(kSarifNames, "x", at(source, "A"));
  findings.add(kSarifNames, "x", at(source, "B"));
  findings.add(kSarifNames, "x `1`", at(source, "A"));
  findings.add(kSarifNames, "x `2`", at(source, "A"));
  auto all = fingerprints(report_of(std::move(findings)));
  CHECK(std::unique(all.begin(), all.end()) == all.end());
}

TEST_CASE("The fingerprint of a finding without a symbol ignores numbers in its text") {
  const auto one = [](const std::string& words) {
    diag::Diagnostics findings;
    findings.add(kSarifNames, words, at(list("A\n"), "A"));
    return fingerprints(report_of(std::move(findings)));
  };
  CHECK(one("row 12 of `X1`") == one("row 7 of `X1`"));
  CHECK(one("row 12 of `X1`") != one("row 12 of `X2`"));
}

TEST_CASE("Several plants make one run, each result names its plant") {
  std::vector<diag::Report> reports = about_rows({"A"});
  diag::Diagnostics findings;
  findings.add(kSarifTwice, about({"B"}), "x", {});
  reports.push_back({"line2.json", std::move(findings)});
  const json run = run_of(reports);
  CHECK(run["results"][0]["properties"]["plant"] == "line2.json");
  CHECK(run["results"][1]["properties"]["plant"] == "plant.json");
}

TEST_CASE("Results above the limit of a run are counted, the most severe stay") {
  diag::Diagnostics findings;
  for (std::size_t i = 0; i < diag::kMostSarifResults + 5; ++i)
    findings.add(kSarifRest, about({std::to_string(i)}), "x", {});
  findings.add(kSarifTwice, about({"A"}), "x", {});
  const json run = run_of(report_of(std::move(findings)));
  CHECK(run["results"].size() == diag::kMostSarifResults);
  CHECK(run["results"][0]["ruleId"] == "SP302");
  CHECK(run["invocations"][0]["toolExecutionNotifications"][0]["message"]["text"] ==
        "6 findings of the lowest severity are left out, because a run holds at most 25000; choose with --select, or "
        "list all with --format json");
}

TEST_CASE("User text in SARIF is no link, no argument and no control character") {
  CHECK(diag::sarif_text("A](1) B{0} C[0] {x}\n") == "A<U+005D>(1) B<U+007B>0} C[0] {x}<U+000A>");
  diag::Diagnostics findings;
  findings.add(kSarifNames, about({"\xFF"}), "bad \xFF \xE2\x80\xAE", at(list("\xE2\x80\xAE\n"), "\xE2\x80\xAE"));
  const json run = run_of(report_of(std::move(findings)));
  CHECK(run["results"][0]["message"]["text"] == "bad \xEF\xBF\xBD <U+202E>");
  CHECK_FALSE(run["results"][0]["locations"][0]["physicalLocation"]["region"].contains("snippet"));
}

TEST_CASE("A file's URI is encoded byte by byte, and relative if possible") {
  CHECK(diag::file_uri("a/./b/../c.csv", "/home/ci") == "a/c.csv");
  CHECK(diag::file_uri("/home/ci/a.csv", "/home/ci") == "a.csv");
  CHECK(diag::file_uri("/home/ci/a.csv", "/home/ci/") == "a.csv");
  CHECK(diag::file_uri("/home/cider/a.csv", "/home/ci") == "file:///home/cider/a.csv");
  CHECK(diag::file_uri("/home/ci/a.csv", "") == "file:///home/ci/a.csv");
  CHECK(diag::file_uri("../a.csv", "/home/ci") == "../a.csv");
#ifndef _WIN32
  CHECK(diag::file_uri("1:2 %?#\\\xED\x81\xB4\xFF.csv", "") == "1%3A2%20%25%3F%23%5C%ED%81%B4%FF.csv");
#else
  CHECK(diag::file_uri("C:\\ci\\x y\\a.csv", "C:/ci") == "x%20y/a.csv");
  CHECK(diag::file_uri("C:\\ci\\a.csv", "D:/ci") == "file:///C:/ci/a.csv");
  CHECK(diag::file_uri("\\x\\a.csv", "D:/ci") == "file:///D:/x/a.csv");
#endif
}

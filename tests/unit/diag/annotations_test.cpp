// Findings as annotations of build servers.
#include "diag/annotations.hpp"

#include <nlohmann/json.hpp>

#include "support/catch.hpp"
#include "support/strings.hpp"

namespace symplant::diag {
namespace {

constexpr RuleInfo kWarning{"SP305", "direction-against-address", Severity::warning, "", ""};
constexpr RuleInfo kError{"SP101", "cannot-read-file", Severity::error, "", ""};
constexpr RuleInfo kNote{"SP501", "inferred-rest-state", Severity::note, "", ""};

std::vector<Report> reports() {
  std::vector<Report> all(1);
  all[0].plant = "/repo/a,b.csv";
  const auto file = std::make_shared<text::SourceFile>("/repo/a,b.csv", "head\nVAR,X\n");
  all[0].findings.add(kWarning, "50 % of `a`,\n`b`: odd", {file, {9, 10}});
  all[0].findings.add(kError, "cannot read", {});
  return all;
}

TEST_CASE("GitHub's commands have the file relative to the folder, and escaped texts") {
  CHECK(render_github(reports(), "/repo") ==
        "::error title=SP101 cannot-read-file::cannot read\n"
        "::warning file=a%2Cb.csv,line=2,col=5,title=SP305 direction-against-address::50 %25 of "
        "`a`,<U+000A>`b`: odd\n");
  CHECK(test::contains(render_github(reports(), "/rep"), "file=/repo/a%2Cb.csv,"));
  CHECK(render_github({}, "").empty());
}

TEST_CASE("GitHub gets ten annotations of a level, the rest is counted") {
  std::vector<Report> all(1);
  for (int i = 0; i < 12; ++i) all[0].findings.add(kWarning, "odd", {});
  for (int i = 0; i < 11; ++i) all[0].findings.add(kNote, "note", {});
  const std::string text = render_github(all, "");
  std::size_t warnings = 0;
  std::size_t notices = 0;
  for (std::size_t at = text.find("::warning"); at != text.npos; at = text.find("::warning", at + 1)) ++warnings;
  for (std::size_t at = text.find("::notice"); at != text.npos; at = text.find("::notice", at + 1)) ++notices;
  CHECK(warnings == 10);
  CHECK(notices == 10);
  CHECK_THAT(text, Catch::Matchers::EndsWith("::2 more warnings, 2 more notes: run symplant check --verbose\n"));
}

TEST_CASE("GitLab's report is valid JSON with a fingerprint that rows do not change") {
  const auto issues = nlohmann::json::parse(render_gitlab(reports(), "/repo"));
  REQUIRE(issues.size() == 2);
  CHECK(issues[0]["location"]["path"] == "a,b.csv");
  CHECK(issues[0]["location"]["lines"]["begin"] == 2);
  CHECK(issues[0]["severity"] == "major");
  CHECK(issues[0]["check_name"] == "SP305 direction-against-address");
  CHECK(issues[1]["location"]["path"] == "a,b.csv");  // of the plant
  CHECK(issues[1]["location"]["lines"]["begin"] == 1);
  CHECK(issues[1]["severity"] == "critical");
  CHECK(issues[0]["fingerprint"] != issues[1]["fingerprint"]);
  CHECK(render_gitlab({}, "") == "[]\n");
}

}  // namespace
}  // namespace symplant::diag

// Findings as JSON.
#include "diag/json.hpp"

#include <nlohmann/json.hpp>

#include "support/catch.hpp"

using namespace symplant;
using nlohmann::json;

namespace {

constexpr diag::RuleInfo kJsonRule{"SP201", "wrong-number-of-levels", diag::Severity::warning, "", ""};

}  // namespace

TEST_CASE("JSON has the rule, the location and the related locations of each finding") {
  const auto source = std::make_shared<const text::SourceFile>("list.csv", "\xC3\x84,X1\nA,X2\n");
  diag::Diagnostics found;
  std::vector<diag::Related> related(1);
  related[0].location = {source, {0, 2}};
  related[0].message = "first";
  found.add(kJsonRule, "say `A` \"once\"", {source, {6, 7}}, related);
  const json document = json::parse(diag::render_json(found.all()));
  CHECK(document == json::parse(R"({
    "symplant-diagnostics": 1,
    "findings": [{
      "rule": "SP201", "slug": "wrong-number-of-levels", "severity": "warning", "message": "say `A` \"once\"",
      "file": "list.csv", "line": 2, "column": 1, "end_line": 2, "end_column": 2, "span": [6, 7],
      "related": [{"message": "first", "file": "list.csv", "line": 1, "column": 1, "end_line": 1, "end_column": 2,
                   "span": [0, 2]}]
    }],
    "counts": {"error": 0, "warning": 1, "note": 0}
  })"));
}

TEST_CASE("JSON without findings is complete") {
  CHECK(diag::render_json({}) ==
        "{\n  \"symplant-diagnostics\": 1,\n  \"findings\": [],\n  \"counts\": {\n    \"error\": 0,\n    \"warning\": "
        "0,\n"
        "    \"note\": 0\n  }\n}\n");
}

TEST_CASE("Invalid UTF-8 does not break the report") {
  diag::Diagnostics found;
  found.add(kJsonRule, "bad \xFF", {std::make_shared<text::SourceFile>("\xFE.csv", ""), {}});
  const json document = json::parse(diag::render_json(found.all()));
  CHECK(document["findings"][0]["message"] == "bad \xEF\xBF\xBD");
  CHECK_FALSE(document["findings"][0].contains("line"));
}

// Findings of one rule and one shape.
#include "findings/finish.hpp"
#include "support/catch.hpp"

namespace symplant::findings {
namespace {

constexpr diag::RuleInfo kFirst{"SP401", "operation-without-event", diag::Severity::warning, "", ""};
constexpr diag::RuleInfo kSecond{"SP402", "event-without-operation", diag::Severity::warning, "", ""};

diag::Diagnostics found(const std::vector<std::pair<std::string, std::string>>& names_and_shapes) {
  diag::Diagnostics all;
  for (const auto& [name, shape] : names_and_shapes) {
    diag::Subjects subjects{{{diag::Subject::Kind::symbol, name}}, {}, {}, shape};
    all.add(kFirst, std::move(subjects), "`" + name + "` is odd", {}, {{{}, "near " + name}});
  }
  return all;
}

TEST_CASE("Findings of one rule and shape become one, with their number and three examples") {
  const diag::Diagnostics rolled =
      roll_up(found({{"A1", "A#"}, {"B", "B"}, {"A2", "a#"}, {"A3", "A#"}, {"A4", "A#"}, {"A5", "A#"}}));
  REQUIRE(rolled.all().size() == 2);
  const diag::Diagnostic& joined = rolled.all()[0];
  CHECK(joined.message == "`A1` is odd; 4 more like `A#`: `A2`, `A3`, `A4` and 1 more");
  CHECK(joined.count == 5);
  REQUIRE(joined.related.size() == 9);  // its own, and each other with its own
  CHECK(joined.related[1].message == "also: `A2` is odd");
  CHECK(joined.related[2].message == "near A2");
  CHECK(rolled.all()[1].message == "`B` is odd");
  CHECK(rolled.count(diag::Severity::warning) == 2);
}

TEST_CASE("The severity of the most severe one counts, and what is ignored stays so") {
  diag::Diagnostics all = found({{"A1", "A#"}});
  diag::Diagnostic error = all.all().front();
  error.severity = diag::Severity::error;
  all.add(error);
  all.ignore(error, "known");
  const diag::Diagnostics rolled = roll_up(std::move(all));
  REQUIRE(rolled.all().size() == 1);
  CHECK(rolled.has_errors());
  CHECK(rolled.ignored().size() == 1);
}

TEST_CASE("Findings of other rules, of shapes without a number, or without a subject stay single") {
  diag::Diagnostics all = found({{"A1", "A#"}, {"B", "B"}, {"B", "B"}, {"C1", ""}, {"C2", ""}});
  all.add(kSecond, {{{diag::Subject::Kind::symbol, "A2"}}, {}, {}, "A#"}, "other", {});
  all.add(kFirst, "none", {});
  CHECK(roll_up(std::move(all)).all().size() == 7);
}

}  // namespace
}  // namespace symplant::findings

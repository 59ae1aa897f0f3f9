// --select and --ignore: the rules that a run reports.
#include "findings/selection.hpp"

#include "check/catalogue.hpp"
#include "findings/finish.hpp"
#include "unit/check/check_support.hpp"

namespace symplant::test {
namespace {

using findings::Selection;
using Words = std::vector<std::string>;

std::string fault(const Words& select, const Words& ignore) {
  const auto selection = Selection::of(select, ignore);
  return selection ? "" : selection.error();
}

/// The verdict on a rule as text.
std::string verdict(const Words& select, const Words& ignore, std::string_view rule) {
  const auto selection = Selection::of(select, ignore);
  REQUIRE(selection);
  switch (selection->verdict(*check::find_rule(rule))) {
    case Selection::Verdict::reported:
      return "reported";
    case Selection::Verdict::not_selected:
      return "not selected";
    case Selection::Verdict::ignored:
      return "ignored";
  }
  return "";
}

TEST_CASE("Without words every rule is reported") {
  for (const diag::RuleInfo* rule : check::catalogue()) CHECK(verdict({}, {}, rule->id) == "reported");
}

TEST_CASE("A word is an id, a slug or the prefix of an id, in any case") {
  for (const char* word :
       {"SP402", "sp402", "event-without-operation", "Event-Without-Operation", "SP40", "SP4", "sp"}) {
    INFO(word);
    CHECK(verdict({word}, {}, "SP402") == "reported");
    CHECK(verdict({}, {word}, "SP402") == "ignored");
  }
  CHECK(verdict({"SP5"}, {}, "SP402") == "not selected");
  CHECK(verdict({"SP2", "SP4"}, {}, "SP402") == "reported");
}

TEST_CASE("A former name selects the current rule, and is returned once") {
  CHECK(verdict({"nobody-moves"}, {}, "SP404") == "reported");
  CHECK(verdict({"nobody-moves"}, {}, "SP402") == "not selected");
  CHECK(verdict({"SP4"}, {"Nobody-Moves"}, "SP404") == "ignored");
  const auto selection = Selection::of(Words{"nobody-moves", "SP4"}, Words{"NOBODY-MOVES", "places-overlap"});
  CHECK_FALSE(selection);  // an error that leaves no valid plant is not ignored by its former name, either
  CHECK(Selection::of(Words{"nobody-moves", "SP4"}, Words{"nobody-moves"})->former() ==
        std::set<std::string>{"nobody-moves"});
  CHECK(Selection::of({}, Words{"SP312"})->former() == std::set<std::string>{"SP312"});  // removed: no effect
  CHECK(Selection::of(Words{"SP404"}, Words{"event-not-driven"})->former().empty());
}

TEST_CASE("The more exact word of --select and --ignore counts, --ignore if they are equal") {
  CHECK(verdict({"SP4"}, {"SP402"}, "SP402") == "ignored");
  CHECK(verdict({"SP402"}, {"SP4"}, "SP402") == "reported");
  CHECK(verdict({"SP402"}, {"SP4"}, "SP404") == "not selected");
  CHECK(verdict({"SP40"}, {"SP4"}, "SP402") == "reported");
  CHECK(verdict({"SP4"}, {"SP4"}, "SP402") == "ignored");
  CHECK(verdict({"SP402"}, {"event-without-operation"}, "SP402") == "ignored");
}

TEST_CASE("An error that leaves no valid plant is always reported, and cannot be ignored by its name") {
  CHECK(verdict({"SP5"}, {"SP1"}, "cannot-read-file") == "reported");
  CHECK(verdict({"SP5"}, {"SP3"}, "symbols-overlap") == "reported");
  CHECK(fault({}, {"SP316"}) ==
        "`symbols-overlap` cannot be ignored: with this error there is no valid plant; fix its cause");
  CHECK(fault({"SP316"}, {}).empty());
  CHECK(verdict({}, {"SP302"}, "SP302") == "ignored");  // the first of two rows counts
}

TEST_CASE("An unknown word is rejected with the nearest one") {
  CHECK(fault({"event-not-drven"}, {}) == "unknown rule `event-not-drven`; did you mean `event-not-driven`?");
  CHECK(fault({}, {"loud"}) == "unknown rule `loud`; `symplant rules` lists all");
  for (const char* word : {"S", "SP9", "SP4x", "SP4011", "4", "*"}) {
    INFO(word);
    CHECK_FALSE(fault({word}, {}).empty());
    CHECK_FALSE(fault({}, {"SP4", word}).empty());
  }
  CHECK(fault({"SP4", ""}, {}) ==
        "a rule is missing next to a comma: write ids, slugs or beginnings of ids, such as SP4");
}

TEST_CASE("Hidden findings are counted by option, those that plant.json ignores by rule") {
  description::Description description;
  description.check.ignore = {{"SP402", "", "later", ""}};
  const Analysed list =
      analyse_lists({{"symbols.csv", list_text(bits({"L_P_S_O_P1", "L_P_S_I_P1", "L_P_S_O_P2", "L_P_S_I_P2",
                                                     "L_P_S_I_HOT", "L_P_B_I_ON1", "L_P_B_I_OFF2", "START", "STOP"}))}},
                    std::move(description), "2026-11-21");
  REQUIRE(list.fired() == "event-not-driven wrong-number-of-levels wrong-number-of-levels");
  REQUIRE(list.diagnostics.ignored().size() == 1);

  const auto chosen = [&](const Words& select, const Words& ignore) {
    return findings::sift(list.diagnostics, {}, {}, *Selection::of(select, ignore));
  };
  const diag::Diagnostics names = chosen({"SP2"}, {});
  CHECK(names.all().size() == 2);
  CHECK(names.ignored().empty());
  CHECK(names.left_out().not_selected == 1);
  CHECK(names.left_out().ignored == 0);
  const diag::Diagnostics models = chosen({}, {"SP2"});
  CHECK(models.all().size() == 1);
  CHECK(models.count(diag::Severity::warning) == 0);
  CHECK(models.ignored().size() == 1);
  CHECK(models.left_out().ignored == 2);
  const diag::Diagnostics all = chosen({}, {});
  CHECK(all.all().size() == 3);
  CHECK(all.left_out().ignored + all.left_out().not_selected == 0);
}

}  // namespace
}  // namespace symplant::test

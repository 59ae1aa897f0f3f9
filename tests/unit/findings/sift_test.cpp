// The section `check`: ignored findings, changed severities, and faults of the section.
#include "check/catalogue.hpp"
#include "findings/finish.hpp"
#include "unit/check/check_support.hpp"

namespace symplant::test {
namespace {

/// SPARE reports a state that it never reaches (SP402), the events of B and C are not driven (SP404).
const std::vector<std::string> kNames = {"L_P_SPARE_O_P1", "L_P_SPARE_I_P1",  "L_P_SPARE_O_P2",
                                         "L_P_SPARE_I_P2", "L_P_SPARE_I_HOT", "L_P_B_I_ON1",
                                         "L_P_B_I_OFF2",   "L_P_C_I_ON1",     "L_P_C_I_OFF2"};

Analysed with(std::vector<description::GivenCheck::Ignore> ignore,
              std::vector<std::pair<std::string, std::string>> severity = {}, std::string_view today = "2026-11-21") {
  description::Description description;
  description.check.ignore = std::move(ignore);
  description.check.severity = std::move(severity);
  return analyse_lists({{"symbols.csv", list_text(bits(kNames))}}, std::move(description), today);
}

TEST_CASE("Without settings every finding is reported") {
  CHECK(with({}).fired() == "event-without-operation event-not-driven event-not-driven");
}

TEST_CASE("A rule's name or id ignores a finding on a symbol or device, and it is counted with its reason") {
  for (const char* rule : {"event-without-operation", "SP402", "sp402"}) {
    for (const char* symbols : {"L_P_SPARE_I_HOT", "L_P_SPARE", "*_SPARE*", "l_p_spare?i_hot", ""}) {
      INFO(rule << " " << symbols);
      const Analysed list = with({{rule, symbols, "comes later", ""}});
      CHECK(list.fired() == "event-not-driven event-not-driven");
      REQUIRE(list.diagnostics.ignored().size() == 1);
      CHECK(list.diagnostics.ignored()[0].why == "comes later");
      CHECK(list.diagnostics.count(diag::Severity::warning) == 0);
    }
  }
  CHECK(with({{"event-not-driven", "L_P_B", "a button", ""}}).fired() == "event-without-operation event-not-driven");
}

TEST_CASE("An entry counts through its last day, and is reported after it") {
  const auto fired = [](std::string_view today) {
    return with({{"SP402", "*", "later", "2026-11-21"}}, {}, today).fired();
  };
  CHECK(fired("2026-11-20") == "event-not-driven event-not-driven");
  CHECK(fired("2026-11-21") == "event-not-driven event-not-driven");
  CHECK(fired("2026-11-22") == "settings-outdated event-without-operation event-not-driven event-not-driven");
  CHECK(fired("") == "event-not-driven event-not-driven");
}

TEST_CASE("An entry without effect is reported, also after its day") {
  CHECK(reported(with({{"SP402", "*_MOTOR*", "later", ""}}), "settings-outdated") ==
        "/check/ignore/0: `SP402` of `*_MOTOR*` has no finding: remove this entry");
  CHECK(with({{"SP402", "*_MOTOR*", "later", "2026-01-01"}}).count("settings-outdated") == 1);
  // Of two entries that match, the first hides; the second has no effect.
  CHECK(reported(with({{"SP402", "*", "a", ""}, {"SP402", "*_HOT", "b", ""}}), "settings-outdated") ==
        "/check/ignore/1: `SP402` of `*_HOT` has no finding: remove this entry");
}

TEST_CASE("An unknown rule and an invalid date are reported, the rule with the nearest one") {
  CHECK(reported(with({{"event-not-drven", "*", "x", ""}}), "settings-not-valid") ==
        "/check/ignore/0/rule: unknown rule `event-not-drven`; did you mean `event-not-driven`?");
  CHECK(reported(with({}, {{"loud", "error"}}), "settings-not-valid") ==
        "/check/severity/loud: unknown rule `loud`; `symplant rules` lists all");
  for (const char* date :
       {"2026-02-29", "2026-13-01", "2026-00-10", "2026-6-30", "30.06.2026", "2026-06-31", "tomorrow"}) {
    INFO(date);
    CHECK(with({{"SP402", "*", "x", date}}).count("settings-not-valid") == 1);
  }
  CHECK(with({{"SP402", "*", "x", "2028-02-29"}}).fired() == "event-not-driven event-not-driven");
}

TEST_CASE("A former slug works, with one warning for each") {
  const Analysed list = with({{"nobody-moves", "L_P_B", "a button", ""}, {"Nobody-Moves", "L_P_C", "a button", ""}},
                             {{"nobody-moves", "warning"}});
  CHECK(list.fired() == "settings-outdated event-without-operation");
  CHECK(list.diagnostics.ignored().size() == 2);
  CHECK(reported(list, "settings-outdated") ==
        "/check/severity/nobody-moves: `nobody-moves` is now `event-not-driven`; write the new name");
}

TEST_CASE("A changed severity changes counts and errors") {
  const Analysed list = with({}, {{"event-not-driven", "error"}, {"SP402", "note"}});
  CHECK(list.diagnostics.count(diag::Severity::error) == 2);
  CHECK(list.diagnostics.count(diag::Severity::warning) == 0);
  CHECK(list.diagnostics.count(diag::Severity::note) == 1);
  CHECK(list.diagnostics.has_errors());
}

TEST_CASE("Errors that leave no valid plant are neither lowered nor ignored") {
  CHECK(reported(with({}, {{"symbols-overlap", "note"}}), "settings-not-valid") ==
        "/check/severity/symbols-overlap: `symbols-overlap` cannot be lowered: with this error there is "
        "no valid plant; fix its cause");
  CHECK(with({{"SP101", "*", "x", ""}}).count("settings-not-valid") == 1);
  CHECK(with({}, {{"symbols-overlap", "error"}}).count("settings-not-valid") == 0);
  CHECK_FALSE(findings::is_binding(*check::find_rule("SP302")));
  CHECK_FALSE(findings::is_binding(*check::find_rule("SP304")));
}

}  // namespace
}  // namespace symplant::test

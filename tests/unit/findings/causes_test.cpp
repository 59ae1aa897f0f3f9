// Consequences are below their cause; no finding is lost, and hidden findings stay hidden.
#include "findings/causes.hpp"

#include <algorithm>

#include "findings/name_guess.hpp"
#include "unit/check/check_support.hpp"

namespace symplant::test {
namespace {

/// Five clamps with two coils each.
std::vector<Row> clamps() {
  std::vector<std::string> names;
  for (int i = 1; i <= 5; ++i) {
    for (const char* part : {"_O_OPEN", "_O_CLOSE", "_I_OPEN*", "_I_CLOSE"}) {
      names.push_back("BODY_SIDE_CLAMP" + std::to_string(i) + part);
    }
  }
  return bits(names);
}

std::size_t row_of(const std::vector<Row>& rows, const std::string& name) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.name == name; });
  REQUIRE(found != rows.end());
  return static_cast<std::size_t>(found - rows.begin());
}

/// The third clamp's event OPEN has an unknown type.
std::vector<Row> with_lost_event() {
  std::vector<Row> rows = clamps();
  rows[row_of(rows, "BODY_SIDE_CLAMP3_I_OPEN")].type = "BOL";
  return rows;
}

Analysed with_settings(std::vector<Row> rows, description::GivenCheck check) {
  description::Description description;
  description.check = std::move(check);
  return analyse_lists({{"symbols.csv", list_text(rows)}}, std::move(description));
}

bool follows(const Analysed& analysed, std::string_view root, const std::string& slug) {
  for (const diag::Diagnostic& finding : analysed.diagnostics.all()) {
    if (finding.rule->slug != root) continue;
    for (const diag::Related& related : finding.related) {
      if (related.message.find("follows from this (" + slug + "): ") == 0) return true;
    }
  }
  return false;
}

TEST_CASE("Five equal clamps are clean") { CHECK(analyse_rows(clamps()).fired() == ""); }

TEST_CASE("The consequences of a lost symbol are below the reason for its loss") {
  const Analysed list = analyse_rows(with_lost_event());
  CHECK(list.fired() == "type-of-no-io");
  CHECK(follows(list, "type-of-no-io", "shape-lacks-symbol"));
  CHECK(follows(list, "type-of-no-io", "operation-without-event"));
}

TEST_CASE("An ignored cause explains nothing: its consequences are reported again") {
  description::GivenCheck check;
  check.ignore.push_back({"type-of-no-io", "", "so be it", ""});
  const Analysed list = with_settings(with_lost_event(), check);
  CHECK(list.fired() == "shape-lacks-symbol");
  CHECK(follows(list, "shape-lacks-symbol", "operation-without-event"));
}

TEST_CASE("An ignored consequence is counted as ignored, and not shown below its cause") {
  description::GivenCheck check;
  check.ignore.push_back({"shape-lacks-symbol", "BODY_SIDE_CLAMP3", "a clamp of another make", ""});
  const Analysed list = with_settings(with_lost_event(), check);
  CHECK(list.fired() == "type-of-no-io");
  CHECK_FALSE(follows(list, "type-of-no-io", "shape-lacks-symbol"));
  CHECK(list.diagnostics.ignored().size() == 1);
}

TEST_CASE("A cause is as severe as its most severe consequence") {
  description::GivenCheck check;
  check.severity.emplace_back("operation-without-event", "error");
  const Analysed list = with_settings(with_lost_event(), check);
  CHECK(list.fired() == "type-of-no-io");
  CHECK(list.diagnostics.count(diag::Severity::error) == 1);
  CHECK(list.diagnostics.count(diag::Severity::warning) == 0);
}

TEST_CASE("A device of one task that cannot move, or reports nothing, is one finding with its rest state") {
  const Analysed button = analyse_rows(bits({"L_P_D_I_START"}));
  CHECK(button.fired() == "event-not-driven");
  CHECK(follows(button, "event-not-driven", "inferred-rest-state"));
  const Analysed lamp = analyse_rows(bits({"L_P_D_O_ON"}));
  CHECK(lamp.fired() == "unit-without-events");
  CHECK(follows(lamp, "unit-without-events", "inferred-rest-state"));
  const Analysed motor = analyse_rows(bits({"L_P_D_O_ON", "L_P_D_I_ON"}));
  CHECK(motor.fired() == "inferred-rest-state");
}

TEST_CASE("Two symbols on one address follow from the one with contradicting addresses, in either order") {
  for (const bool first : {true, false}) {
    std::vector<Row> rows = bits({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B2", "L_P_D_I_B2"});
    for (Row& row : rows) row.address = (row.iec[1] == 'Q' ? "Y" : "X") + row.iec.substr(3);
    if (first)
      rows[1].iec = rows[3].iec;
    else
      rows[3].iec = rows[1].iec;
    const Analysed list = analyse_rows(rows);
    CHECK(list.fired() == "addresses-contradict");
    CHECK(follows(list, "addresses-contradict", "address-used-twice"));
  }
}

TEST_CASE("Two unrelated faults of one device are two findings") {
  std::vector<Row> rows = bits({"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B2", "L_P_D_O_C3", "L_P_D_I_C3"});
  rows[4].type = "BOL";  // I_C3 is lost, and I_B2 never existed
  const Analysed list = analyse_rows(rows);
  CHECK(list.fired() == "operation-without-event type-of-no-io");
  CHECK(follows(list, "type-of-no-io", "operation-without-event"));
}

TEST_CASE("Folding loses nothing: each finding is separate or below another") {
  for (std::size_t i = 0; i < clamps().size(); ++i) {
    for (const std::string name :
         {"_SIDE_CLAMP3_I_OPEN", "BODY_SIDE_CLAMP_I_CLOSE", "BODY_SIDE_CLAMP3_X_OPEN", "A-B"}) {
      std::vector<Row> rows = clamps();
      rows[i].name = name;
      Analysed folded = analyse_rows(rows);
      diag::Diagnostics plain;
      check::check_plant(folded.model(), folded.evidence(), plain);
      std::size_t reported = 0;
      for (const diag::Diagnostic& finding : folded.diagnostics.all()) {
        ++reported;
        for (const diag::Related& related : finding.related) {
          reported += related.message.starts_with("follows from this (") ? 1U : 0U;
        }
      }
      INFO(rows[i].name << " for row " << i << ": " << folded.fired());
      CHECK(reported == plain.all().size());
    }
  }
}

std::vector<std::string> guesses(const std::string& name) {
  std::vector<std::string> names;
  for (const findings::NameGuess& guess : findings::guess_names(name, name::built_in_rule()))
    names.push_back(guess.name());
  return names;
}

bool guessed(const std::string& name, const std::string& meant) {
  const std::vector<std::string> names = guesses(name);
  return std::find(names.begin(), names.end(), meant) != names.end();
}

TEST_CASE("A name that breaks the rule is read with one level unknown, joined, or removed") {
  CHECK(guesses("L_P_D__T") == std::vector<std::string>{"L_P_D_*_T"});
  CHECK(guesses("l_p_d_x_t") == std::vector<std::string>{"L_P_D_*_T"});
  CHECK(guessed("L_P_D_T", "L_P_D_*_T"));
  CHECK(guessed("L_P_I_T", "L_P_*_I_T"));
  CHECK(guessed("L_P_D_I", "L_P_D_I_*"));
  CHECK(guessed("L_P_D_1_I_T", "L_P_D1_I_T"));
  CHECK(guessed("L_P_D_OLD_I_T", "L_P_D_I_T"));
  CHECK(guessed("L_P_D-I_T", "L_P_D_I_T"));
  CHECK(guessed("L_P_D I_T1", "L_P_D_I_T1"));
  CHECK(guessed("L_P_D1._I_T", "L_P_D1_I_T"));
  CHECK(guesses("START").empty());
  CHECK(guesses("").empty());
}

}  // namespace
}  // namespace symplant::test

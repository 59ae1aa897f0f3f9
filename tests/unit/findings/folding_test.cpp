// Consequences are shown below their cause; nothing is lost, and an ignored finding takes what follows from it along.
#include <algorithm>
#include <set>

#include "app/options.hpp"
#include "check/catalogue.hpp"
#include "findings/finish.hpp"
#include "support/findings.hpp"
#include "unit/check/check_support.hpp"

namespace symplant::test {
namespace {

/// The slug of SP304.
const std::string kDrivenTwice(check::find_rule("SP304")->slug);

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

Analysed selected(const std::vector<Row>& rows, const std::vector<std::string>& select,
                  const std::vector<std::string>& ignore) {
  return analyse_lists({{"symbols.csv", list_text(rows)}}, {}, {}, *findings::Selection::of(select, ignore));
}

description::GivenCheck ignoring(const std::string& rule) {
  description::GivenCheck check;
  check.ignore.push_back({rule, "", "so be it", ""});
  return check;
}

/// Those of one shape count each.
std::size_t single_findings(const Analysed& analysed) {
  std::size_t count = 0;
  for (const diag::Diagnostic& finding : analysed.diagnostics.all()) count += finding.count;
  return count;
}

std::size_t rows_that_follow(const Analysed& analysed) {
  std::size_t rows = 0;
  for (const diag::Diagnostic& finding : analysed.diagnostics.all()) rows += finding.shown_consequences;
  return rows;
}

TEST_CASE("Five equal clamps are clean") { CHECK(analyse_rows(clamps()).fired() == ""); }

TEST_CASE("The consequences of a lost symbol are below the reason for its loss") {
  const Analysed list = analyse_rows(with_lost_event());
  CHECK(list.fired() == "type-of-no-io");
  CHECK(follows(list, "type-of-no-io", "shape-lacks-symbol"));
  CHECK(follows(list, "type-of-no-io", "operation-without-event"));
}

TEST_CASE("What follows from an ignored finding is ignored with it") {
  description::GivenCheck check;
  check.ignore.push_back({"type-of-no-io", "", "so be it", ""});
  const Analysed list = with_settings(with_lost_event(), check);
  CHECK(list.fired() == "");
  REQUIRE(list.diagnostics.ignored().size() == 1);
  CHECK(list.diagnostics.ignored()[0].finding.shown_consequences == 2);
  CHECK(app::count_text(list.diagnostics) == "no findings, 1 ignored by plant.json and 2 that follow from them");
}

TEST_CASE("What is more severe than the ignored finding it follows from is reported") {
  description::GivenCheck check;
  check.ignore.push_back({"type-of-no-io", "", "so be it", ""});
  check.severity.emplace_back("operation-without-event", "error");
  const Analysed list = with_settings(with_lost_event(), check);
  CHECK(list.fired() == "operation-without-event");
  CHECK(list.diagnostics.count(diag::Severity::error) == 1);
  CHECK(list.diagnostics.ignored().size() == 1);
}

TEST_CASE("An address that is wrong in one of its columns explains that two devices drive it") {
  std::vector<Row> rows = bits(
      {"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B2", "L_P_D_I_B2", "L_P_E_O_A1", "L_P_E_I_A1", "L_P_E_O_B2", "L_P_E_I_B2"});
  for (Row& row : rows) row.address = (row.iec[1] == 'Q' ? "Y" : "X") + row.iec.substr(3);
  rows[5].iec = rows[3].iec;
  const Analysed plain = analyse_rows(rows);
  REQUIRE(plain.fired() == "addresses-contradict");
  REQUIRE(follows(plain, "addresses-contradict", kDrivenTwice));
  description::GivenCheck check;
  check.ignore.push_back({"addresses-contradict", "", "so be it", ""});
  CHECK(with_settings(rows, check).fired() == "");
  check.severity.emplace_back(kDrivenTwice, "error");
  CHECK(with_settings(rows, check).fired() == kDrivenTwice);
  CHECK(selected(rows, {}, {"addresses-contradict"}).fired() == "");
  CHECK(selected(rows, {"SP304"}, {}).fired() == kDrivenTwice);
}

/// Clamps with a fault of every rank, buttons and lamps.
std::vector<Row> with_many_faults() {
  std::vector<Row> rows = with_lost_event();
  rows[row_of(rows, "BODY_SIDE_CLAMP1_I_OPEN")].initial = "TURE";
  rows[row_of(rows, "BODY_SIDE_CLAMP2_I_OPEN")].name = "BODY_SIDE_CLAMP2_X_OPEN";
  rows[row_of(rows, "BODY_SIDE_CLAMP4_I_OPEN")].name = "BODY_SIDE_CLMAP4_I_OPEN";
  rows[row_of(rows, "BODY_SIDE_CLAMP5_O_CLOSE")].iec = "%IX900";
  for (const Row& row : bits({"L_P_BUTTON1_I_START", "L_P_BUTTON2_I_START", "L_P_LAMP1_O_ON", "L_P_LAMP2_O_ON",
                              "L_P_S_O_P1", "L_P_S_I_P1", "L_P_S_O_P2", "L_P_S_I_P2", "L_P_S_O_P4", "L_P_S_I_P4"})) {
    rows.push_back(row);
    rows.back().iec.replace(3, 0, "9");
  }
  return rows;
}

TEST_CASE("To ignore a rule never raises the count of another one") {
  const std::vector<Row> rows = with_many_faults();
  const Analysed plain = analyse_rows(rows);
  std::set<std::string> fired;
  for (const diag::Diagnostic& finding : plain.diagnostics.all()) fired.insert(std::string(finding.rule->slug));
  INFO(plain.fired());
  CHECK(fired.size() >= 7);
  for (const std::string& ignored : fired) {
    const Analysed left = selected(rows, {}, {ignored});
    const Analysed set = with_settings(rows, ignoring(ignored));
    for (const diag::RuleInfo* rule : check::catalogue()) {
      INFO("without " << ignored << ": " << rule->slug);
      const std::size_t most = rule->slug == ignored ? 0 : plain.count(rule->slug);
      CHECK(left.count(rule->slug) == most);
      CHECK(set.count(rule->slug) == most);
    }
    const diag::LeftOutByOption& counts = left.diagnostics.left_out();
    CHECK(counts.ignored >= plain.count(ignored));
    CHECK(single_findings(plain) + rows_that_follow(plain) ==
          single_findings(left) + rows_that_follow(left) + counts.total());
  }
}

TEST_CASE("A name with an unknown direction explains how its device is derived") {
  std::vector<Row> rows = bits({"L_P_D_O_A", "L_P_D_X_A*", "L_P_D_O_B", "L_P_D_I_B"});
  const Analysed list = analyse_rows(rows);
  CHECK(list.fired() == "direction-not-io");
  CHECK(follows(list, "direction-not-io", "operation-without-event"));
}

TEST_CASE("A selected rule is reported, whatever it follows from") {
  CHECK(selected(with_lost_event(), {"SP401"}, {}).fired() == "operation-without-event");
  const Analysed devices = selected(with_lost_event(), {"SP4"}, {});
  CHECK(devices.fired() == "shape-lacks-symbol");  // the next cause
  CHECK(follows(devices, "shape-lacks-symbol", "operation-without-event"));
  const Analysed types = selected(with_lost_event(), {"SP313"}, {});
  CHECK(types.fired() == "type-of-no-io");
  CHECK_FALSE(follows(types, "type-of-no-io", "shape-lacks-symbol"));
  CHECK(types.diagnostics.left_out().not_selected == 2);
}

TEST_CASE("A related row of an ignored rule disappears from a cause that stays") {
  const Analysed list = selected(with_lost_event(), {}, {"SP414"});
  CHECK(list.fired() == "type-of-no-io");
  CHECK_FALSE(follows(list, "type-of-no-io", "shape-lacks-symbol"));
  CHECK(follows(list, "type-of-no-io", "operation-without-event"));
  CHECK(list.diagnostics.left_out().ignored == 1);
  CHECK(list.diagnostics.left_out().consequences == 0);
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

TEST_CASE("A device of one task has a finding if nothing drives it") {
  CHECK(analyse_rows(bits({"L_P_D_I_START"})).fired() == "event-not-driven");
  CHECK(analyse_rows(bits({"L_P_D_O_ON"})).fired() == "");
  CHECK(analyse_rows(bits({"L_P_D_O_ON", "L_P_D_I_ON"})).fired() == "");
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

// fold() itself, on findings made by hand.
constexpr diag::RuleInfo kCause{"SP901", "cause", diag::Severity::warning, "", "", diag::Rank::name};
constexpr diag::RuleInfo kBetter{"SP902", "better", diag::Severity::warning, "", "", diag::Rank::address};
constexpr diag::RuleInfo kEffect{"SP903", "effect", diag::Severity::note, "", ""};

diag::Subject subject(diag::Subject::Kind kind, const std::string& name) { return {kind, name}; }

/// The rules of the findings that are left, each with those of its consequences in brackets.
std::string folded(diag::Diagnostics findings) {
  findings::fold(findings);
  std::string text;
  for (const diag::Diagnostic& finding : findings.all()) {
    text += (text.empty() ? "" : " ") + std::string(finding.rule->slug);
    for (const diag::Diagnostic& each : finding.consequences) text += "(" + std::string(each.rule->slug) + ")";
  }
  return text;
}

/// A cause that explains one subject, and an effect that follows another.
std::string folded(const diag::Subject& explained, const diag::Subject& followed) {
  diag::Diagnostics findings;
  findings.add(kEffect, diag::Subjects{{}, {}, {followed}}, "effect", {});
  findings.add(kCause, diag::Subjects{{}, {explained}, {}}, "cause", {});
  return folded(std::move(findings));
}

TEST_CASE("A finding follows from one that explains its subject: of the same kind and name") {
  using Kind = diag::Subject::Kind;
  CHECK(folded(subject(Kind::device, "L_P_D"), subject(Kind::device, "l_p_d")) == "cause(effect)");
  CHECK(folded(subject(Kind::device, "L_P_D"), subject(Kind::device, "L_P_E")) == "effect cause");
  CHECK(folded(subject(Kind::device, "L_P_D"), subject(Kind::model, "L_P_D")) == "effect cause");
}

TEST_CASE("Of two causes the one of the lower rank counts, and no finding follows from one of the same rank") {
  const diag::Subject device = subject(diag::Subject::Kind::device, "D");
  const diag::Subject symbol = subject(diag::Subject::Kind::symbol, "S");
  diag::Diagnostics findings;
  findings.add(kCause, diag::Subjects{{}, {device}, {device}}, "cause", {});
  findings.add(kBetter, diag::Subjects{{}, {symbol}, {}}, "better", {});
  findings.add(kCause, diag::Subjects{{}, {device}, {device}}, "cause", {});
  findings.add(kEffect, diag::Subjects{{}, {}, {device, symbol}}, "effect", {});
  CHECK(folded(findings) == "cause better(effect) cause");
}

TEST_CASE("Of two causes that explain one subject the one of the lower rank counts") {
  const diag::Subject device = subject(diag::Subject::Kind::device, "D");
  diag::Diagnostics findings;
  findings.add(kCause, diag::Subjects{{}, {device}, {}}, "cause", {});
  findings.add(kBetter, diag::Subjects{{}, {device}, {}}, "better", {});
  findings.add(kEffect, diag::Subjects{{}, {}, {device}}, "effect", {});
  CHECK(folded(findings) == "cause better(effect)");
}

TEST_CASE("A chain of causes ends in the first one") {
  const diag::Subject device = subject(diag::Subject::Kind::device, "D");
  const diag::Subject symbol = subject(diag::Subject::Kind::symbol, "S");
  diag::Diagnostics findings;
  findings.add(kEffect, diag::Subjects{{}, {}, {device}}, "effect", {});
  findings.add(kCause, diag::Subjects{{}, {device}, {symbol}}, "cause", {});
  findings.add(kBetter, diag::Subjects{{}, {symbol}, {}}, "better", {});
  CHECK(folded(findings) == "better(effect)(cause)");
}

bool meant(const std::string& broken, const std::string& missing) {
  using Kind = diag::Subject::Kind;
  return folded(subject(Kind::name, broken), subject(Kind::missing, missing)) == "cause(effect)";
}

TEST_CASE("A name that breaks the rule may be a missing one that differs in one level, or is divided differently") {
  CHECK(meant("L_P_D__T", "L_P_D_I_T"));
  CHECK(meant("l_p_d_x_t", "L_P_D_O_T"));
  CHECK(meant("L_P_D_T", "L_P_D_I_T"));
  CHECK(meant("L_P_I_T", "L_P_D_I_T"));
  CHECK(meant("L_P_D_I", "L_P_D_I_T"));
  CHECK(meant("L_P_D_1_I_T", "L_P_D1_I_T"));
  CHECK(meant("L_P_D_OLD_I_T", "L_P_D_I_T"));
  CHECK(meant("L_P_D-I_T", "L_P_D_I_T"));
  CHECK(meant("L_P_D I_T1", "L_P_D_I_T1"));
  CHECK(meant("L_P_D1._I_T", "L_P_D1_I_T"));
  CHECK(meant("L_P_CL-MP1_I_T", "L_P_CLAMP1_I_T"));
  CHECK(meant("L__P_D1_I_T", "L_P_D1_I_T"));
  CHECK_FALSE(meant("L__P_D1_I_T", "L_P_D2_I_T"));
  CHECK_FALSE(meant("START", "L_P_D_I_T"));
  CHECK_FALSE(meant("L_P_D_X_T", "L_P_D2_I_T"));
  CHECK_FALSE(meant("L_P_D_X_T", "L_P_D_I_T2"));
}

}  // namespace
}  // namespace symplant::test

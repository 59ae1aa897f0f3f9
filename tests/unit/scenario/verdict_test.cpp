// The message of a failed expectation: expected value, actual value, since when, and the operations that led to it.
#include "scenario_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("A failed expectation reports each wrong symbol, its device and the operations that led to it") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"0.5s","set":{"L_P_AGV_O_P2":true}},{"at":"0.7s","set":{"L_P_AGV_O_P2":false}},
                             {"at":"1.4s","expect":{"L_P_AGV_I_P2":true,"L_P_AGV_I_P1":false}})");
  CHECK(play.failures() ==
        "expected L_P_AGV_I_P2 = on at 1.4 s; L_P_AGV_I_P2 has been off since the start, PLC input %IX1, event P2 of "
        "L_P_AGV (symbols.csv:3); L_P_AGV has been in P1->P2 since 0.5 s, %QX2 (operation P2, symbols.csv:4) was on "
        "from 0.5 s to 0.7 s, and arrives in 0.1 s\n");
}

TEST_CASE("A failed condition reports what it names") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"1s","expect":"L_P_AGV.P2 or L_P_AGV_O_P1"})");
  CHECK(play.failures() ==
        "expected `L_P_AGV.P2 or L_P_AGV_O_P1` at 1 s; L_P_AGV has been in P1 since the start: %QX2 (operation P2, "
        "symbols.csv:4) has never been on; L_P_AGV_O_P1 has been off since the start, PLC output %QX3, operation P1 of "
        "L_P_AGV (symbols.csv:5)\n");
}

TEST_CASE("A wait for several values reports those that did not come, and what disables their devices") {
  const BenchTables tables({"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "DOOR_I_OPEN1", "DOOR_I_SHUT2"},
                           Reported().disables("DOOR", "OPEN1", "AGV"));
  const Play play(tables, R"({"at":"0.5s","set":{"L_P_AGV_O_P2":true}},
                             {"wait":"L_P_DOOR.OPEN1 and L_P_AGV.P2","within":"2s"})");
  CHECK(play.failures() ==
        "waited 2 s for `L_P_DOOR.OPEN1 and L_P_AGV.P2`, still false at 2.5 s; L_P_AGV has been in P1, disabled by "
        "L_P_DOOR in OPEN1 since the start, %QX2 (operation P2, symbols.csv:4) has been on since 0.5 s; L_P_DOOR has "
        "been in OPEN1 since the start: no operation and no automatic transition moves it\n");
}

TEST_CASE("A symbol of no device reports only itself") {
  const BenchTables tables(Reported(), {{"SPEED", "D1", "INT", "7", "%IW9"}});
  const Play play(tables, R"({"at":"1s","expect":{"SPEED":8}})");
  CHECK(play.failures() ==
        "expected SPEED = 8 at 1 s; SPEED has been 7 since the start, PLC input D1, symbol SPEED (symbols.csv:2): no "
        "device drives it\n");
}

TEST_CASE("A forced symbol is reported as forced, and so are those of a device that does not move") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"0.5s","force":{"L_P_AGV_O_P2":false}},
                             {"at":"0.6s","set":{"L_P_AGV_O_P2":true},"force":{"L_P_AGV_I_P1":false}},
                             {"at":"1s","expect":"L_P_AGV.P2","force":{"L_P_AGV_I_P2":true}},
                             {"at":"2s","expect":{"L_P_AGV_I_P1":true},"release":["L_P_AGV_I_P2","L_P_AGV_O_P2"]})");
  CHECK(
      play.failures() ==
      "expected `L_P_AGV.P2` at 1 s; L_P_AGV has been in P1 since the start: %QX2 (operation P2, symbols.csv:4) has "
      "never been on, forced in line 1; L_P_AGV_I_P1 is forced to off in line 2; L_P_AGV_I_P2 is forced to on in line "
      "3\n"
      "expected L_P_AGV_I_P1 = on at 2 s; L_P_AGV_I_P1 has been off since 0.6 s, forced in line 2, PLC input %IX0, "
      "event P1 of L_P_AGV (symbols.csv:2); L_P_AGV has been in P1->P2 since 2 s, %QX2 (operation P2, symbols.csv:4) "
      "has been on since 2 s, and arrives in 1 s\n");
}

TEST_CASE("A verdict counts the steps with an expectation") {
  const BenchTables tables(kAgv);
  const trace::PlantNames names(tables.rows);
  const auto read = scenario::read_scenario(
      scenario_text(R"({"at":"0s"},{"at":"0s","expect":"L_P_AGV.P1"},{"wait":"L_P_AGV.P1"},{"at":"9s","expect":{}})"),
      names, {});
  REQUIRE(read.scenario);
  using Kind = scenario::Outcome::Kind;
  const std::vector<scenario::Outcome> outcomes = {
      {Kind::done, 0, 1, 0}, {Kind::held, 0, 1, 0}, {Kind::failed, 1, 1, 1}, {Kind::unreached, 2, 0, 0}};
  const scenario::Verdict verdict = scenario::verdict_of(*read.scenario, outcomes);
  CHECK(verdict.held == 1);
  CHECK(verdict.failed == 1);
  CHECK(verdict.unreached == 1);
}

TEST_CASE("A step that only acts counts in a verdict if something of it was refused or not reached") {
  const BenchTables tables(kAgv);
  const trace::PlantNames names(tables.rows);
  const auto read = scenario::read_scenario(
      scenario_text(
          R"({"at":"0s","start":"L_P_AGV slow"},{"at":"0s","start":"L_P_AGV stuck"},)"
          R"({"at":"9s","start":"L_P_AGV slow","set":{"L_P_AGV_O_P2":true}},{"at":"9s","stop":"L_P_AGV slow"})"),
      names, {});
  REQUIRE(read.scenario);
  using Kind = scenario::Outcome::Kind;
  const std::vector<scenario::Outcome> outcomes = {
      {Kind::held, 0, 1, 0}, {Kind::failed, 0, 1, 1}, {Kind::unreached, 1, 0, 0}, {Kind::unreached, 1, 0, 0}};
  const scenario::Verdict verdict = scenario::verdict_of(*read.scenario, outcomes);
  CHECK(verdict.held == 0);
  CHECK(verdict.failed == 1);
  CHECK(verdict.unreached == 1);
}

}  // namespace
}  // namespace symplant::test

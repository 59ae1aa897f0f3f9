// `start` and `stop`: which malfunctions they name, in which order they act, and what a failed step says.
#include "scenario_support.hpp"
#include "support/malfunction_bench.hpp"

namespace symplant::test {
namespace {

const FaultyTables& hall() {
  static const FaultyTables tables({"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1", "PE_I_PART"},
                                   R"({"name":"eye blind","force":{"L_P_PE_I_PART":true}},
                                      {"name":"jam","of":"L_P_AGV","stuck":true},
                                      {"name":"short jam","of":"L_P_AGV","stuck":true,"lasts":"1s"})");
  return tables;
}

std::string step_faults_of(const std::string& steps) {
  const trace::PlantNames names(hall().rows);
  const auto read = scenario::read_scenario(scenario_text(steps), names, {});
  return read.faults.empty() ? "" : faults_text(scenario_text(steps), read.faults.front().faults);
}

TEST_CASE("A scenario starts and stops malfunctions, one or several, of the description or ordinary ones") {
  const Play play(hall(), R"({"at":"1s","start":"EYE BLIND"},{"plus":"1s","stop":["eye blind"]},
                             {"plus":"1s","start":["L_P_AGV slow","L_P_PE_I_PART stuck on"],"set":{"L_P_AGV_O_P2":true}},
                             {"at":"9s"})");
  CHECK(play.changes() ==
        "0:AGV_I_P1=1 1000:PE_I_PART=1 2000:PE_I_PART=0 3000:AGV_I_P1=0 3000:AGV_O_P2=1 3000:PE_I_PART=1 "
        "6000:AGV_I_P2=1");
  CHECK(play.outcomes() == "ddhd");
}

TEST_CASE("In a step malfunctions stop, then start, after releases") {
  const Play play(hall(), R"({"at":"1s","start":"short jam"},
                             {"at":"1.5s","start":"short jam","stop":"short jam"},
                             {"at":"2.2s","set":{"L_P_AGV_O_P2":true}},{"at":"2.4s","expect":"L_P_AGV.P1"},
                             {"at":"2.6s","expect":"L_P_AGV.moving"},
                             {"at":"3s","force":{"L_P_PE_I_PART":false},"start":"eye blind"},
                             {"at":"4s","release":["L_P_PE_I_PART"],"stop":"eye blind"},{"at":"5s"})");
  CHECK(play.outcomes() == "dddhhddd");
  CHECK(play.changes() == "0:AGV_I_P1=1 2200:AGV_O_P2=1 2500:AGV_I_P1=0 3500:AGV_I_P2=1");
}

TEST_CASE("A malfunction acts before the rounds of its step's instant") {
  const Play play(hall(), R"({"at":"1s","set":{"L_P_AGV_O_P2":true},"start":"jam","expect":"L_P_AGV.P1"},
                             {"at":"3s","expect":"L_P_AGV.P1"},{"at":"4s","stop":"jam","expect":"L_P_AGV.moving"})");
  CHECK(play.outcomes() == "hhh");
}

TEST_CASE("An unknown malfunction is an error with the nearest name") {
  CHECK(step_faults_of(R"({"at":"1s","start":"eye blnd"})") ==
        "1:52 `\"eye blnd\"` malfunction `eye blnd` not found; did you mean `eye blind`?\n");
  CHECK(step_faults_of(R"({"at":"1s","stop":["jam","L_P_AVG stuck"]})") ==
        "1:58 `\"L_P_AVG stuck\"` malfunction `L_P_AVG stuck` not found; did you mean `L_P_AGV stuck`?\n");
  CHECK(contains(step_faults_of(R"({"at":"1s","start":"L_P_PE_I_PARTS stuck on"})"),
                 "did you mean `L_P_PE_I_PART stuck on`?"));
  CHECK(contains(step_faults_of(R"({"at":"1s","start":"L_P_AGV_O_P2 stuck on"})"), "not found"));
  CHECK(
      contains(step_faults_of(R"({"at":"1s","start":"nothing like it"})"), "malfunction `nothing like it` not found"));
  CHECK(contains(step_faults_of(R"({"at":"1s","start":7})"), "expected"));
  CHECK(contains(step_faults_of(R"({"wait":"L_P_AGV.P1","start":"jam"})"), "`start`"));
}

TEST_CASE("A step that starts too many ordinary malfunctions fails") {
  std::vector<std::string> names;
  std::string list;
  for (int i = 0; i < 66; ++i) {
    names.push_back("PE" + std::to_string(i) + "_I_PART");
    list += (list.empty() ? "" : ",") + ("\"L_P_" + names.back() + " stuck on\"");
  }
  const BenchTables tables(names);
  const Play play(tables, R"({"at":"1s","start":[)" + list + "]}");
  CHECK(play.outcomes() == "f");
  CHECK(contains(play.failures(),
                 "malfunction `L_P_PE64_I_PART stuck on` cannot start at 1 s: 64 ordinary ones are "
                 "active, malfunction `L_P_PE65_I_PART stuck on` cannot start"));
}

TEST_CASE("A failed expectation names the active malfunctions") {
  const Play play(hall(), R"({"at":"0.5s","start":"jam","set":{"L_P_AGV_O_P2":true}},
                             {"at":"2s","expect":"L_P_AGV.P2"},{"at":"2s","stop":"jam","expect":"L_P_AGV.P2"})");
  CHECK(play.failures() ==
        "expected `L_P_AGV.P2` at 2 s; L_P_AGV has been in P1, disabled by malfunction `jam` since 0.5 s, %QX2 "
        "(operation P2, symbols.csv:4) has been on since 0.5 s\n"
        "expected `L_P_AGV.P2` at 2 s; L_P_AGV has been in P1->P2 since 2 s, %QX2 (operation P2, symbols.csv:4) has "
        "been on since 0.5 s, and arrives in 1 s\n");
}

}  // namespace
}  // namespace symplant::test

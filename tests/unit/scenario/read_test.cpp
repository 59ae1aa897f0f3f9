// Reads scenarios: the message and location of each fault.
#include "scenario_support.hpp"

namespace symplant::test {
namespace {

/// The faults of a scenario for the vehicle, a lamp and a speed; with `carried`, operations of the vehicle belong
/// to the PLC.
std::string faults_of(const std::string& text, bool carried = false) {
  static const BenchTables tables(Reported(), [] {
    std::vector<Row> rows = bits({"L_P_AGV_I_P1", "L_P_AGV_I_P2", "L_P_AGV_O_P2", "START"});
    rows.push_back({"SPEED", "", "INT", "0", "%IW9"});
    return rows;
  }());
  const trace::PlantNames names(tables.rows);
  std::vector<bool> by_plc(tables.rows.symbols.size());
  by_plc[tables.symbol("AGV_O_P2")] = carried;
  const auto read = scenario::read_scenario(text, names, by_plc);
  CHECK(read.scenario.has_value() == read.faults.empty());
  return read.faults.empty() ? "" : faults_text(text, read.faults.front().faults);
}
std::string step_faults(const std::string& steps, bool carried = false) {
  return faults_of("{\"symplant-scenario\":1,\"steps\":[\n" + steps + "]}", carried);
}

TEST_CASE("A scenario may have comments, a schema, and no step") {
  CHECK(faults_of(R"({"$schema":"x", /* a */ "symplant-scenario":1, // b
                      "steps":[]})") == "");
  CHECK(step_faults(R"({"at":"1s"})") == "");
}

TEST_CASE("Another version of the format, nonsense and a plant description have different messages") {
  CHECK(faults_of(R"({"symplant-scenario":2,"steps":[{"loop":1}]})") ==
        "1:22 `2` this scenario has version 2 of the format, this symplant reads version 1\n");
  CHECK(contains(faults_of(R"({"symplant":1,"symbols":[]})"),
                 "`\"symplant\"` this is a plant description, not a scenario"));
  CHECK(contains(faults_of(R"({"symplant-scenario":"1","steps":[]})"), "expected the version of the format, 1"));
  CHECK(contains(faults_of("[]"), "but found an array"));
  CHECK(contains(faults_of("{\"steps\":[]}"), "the key `symplant-scenario` is missing"));
  CHECK(contains(faults_of("not JSON"), "1:"));
}

TEST_CASE("Unknown keys and wrong shapes are reported at their locations, and the other steps are still read") {
  CHECK(step_faults(R"({"at":"1s","expects":{}},
{"at":1},
{"at":"2s","set":{"NONE":true}})") ==
        "2:12 `\"expects\"` the key `expects` is unknown here; did you mean `expect`?\n"
        "3:7 `1` expected a duration such as `1.5s`, but found the number `1`\n"
        "4:19 `\"NONE\"` symbol `NONE` not found\n");
  CHECK(contains(step_faults(R"({"at":"1s","set":{"START":[1]}})"), "expected true, false, a number"));
  CHECK(contains(step_faults(R"({"at":"1s","at":"2s"})"), "at"));  // a key twice
}

TEST_CASE("What an exercise allows matches something of the plant") {
  CHECK(
      faults_of(
          R"({"symplant-scenario":1,"exercise":{"title":"T","allow":["START","l_p_agv","SPE?D","L_*"]},"steps":[]})") ==
      "");
  CHECK(faults_of(R"({"symplant-scenario":1,"exercise":{"title":"T","allow":["START",
"STRAT","*_DOOR_*"]},"steps":[]})") ==
        "2:1 `\"STRAT\"` `STRAT` matches no symbol, device, value, track or place; did you mean `START`?\n"
        "2:9 `\"*_DOOR_*\"` `*_DOOR_*` matches no symbol, device, value, track or place\n");
}

TEST_CASE("A step gives its time once") {
  CHECK(step_faults(R"({"set":{}})") == "2:1 `{` this step has no time; add `at`, `plus` or `wait`\n");
  CHECK(contains(step_faults(R"({"at":"1s","plus":"2s"})"), "2:12 `\"plus\"` `at` already sets the time of this step"));
  CHECK(contains(step_faults(R"({"wait":"START","plus":"2s"})"), "`plus` already sets the time"));
  CHECK(
      contains(step_faults(R"({"at":"1s","within":"2s"})"), "2:12 `\"within\"` `within` is allowed only with `wait`"));
}

TEST_CASE("Durations have the common format") {
  CHECK(contains(step_faults(R"({"at":"soon"})"), "2:7 `\"soon\"` `soon` is not a duration"));
  CHECK(contains(step_faults(R"({"at":"876001h"})"), "the latest time is 100 years"));
  CHECK(contains(step_faults(R"({"at":"800000h"},{"plus":"800000h"})"), "2:26"));
  CHECK(contains(step_faults(R"({"wait":"START","within":"-1s"})"), "is not a duration"));
}

TEST_CASE("An at before the previous steps is a fault, a wait does not count") {
  CHECK(step_faults(R"({"at":"2s"},{"plus":"1s"},{"wait":"START"},{"at":"2.9s"})") ==
        "2:50 `\"2.9s\"` this time is before the `plus` above, which comes at 3 s or later; sort the steps by time\n");
  CHECK(step_faults(R"({"at":"2s"},{"wait":"START","within":"1h"},{"at":"2s"})") == "");
}

TEST_CASE("Names ignore the case of ASCII letters, and an unknown one gives the nearest") {
  CHECK(step_faults(R"({"at":"0s","set":{"start":true},"state":{"l_p_agv":"p2"},"expect":"L_p_AGV.P2"})") == "");
  CHECK(
      contains(step_faults(R"({"at":"0s","set":{"STRAT":true}})"), "symbol `STRAT` not found; did you mean `START`?"));
  CHECK(
      contains(step_faults(R"({"at":"0s","release":["START","STRAT"]})"), "2:31 `\"STRAT\"` symbol `STRAT` not found"));
  CHECK(contains(step_faults(R"({"at":"0s","state":{"L_P_AGB":"P1"}})"),
                 "2:21 `\"L_P_AGB\"` device `L_P_AGB` not found; did you mean `L_P_AGV`?"));
  CHECK(contains(step_faults(R"({"at":"0s","state":{"L_P_AGV":"P3"}})"),
                 "2:31 `\"P3\"` state `P3` of `L_P_AGV` not found; did you mean `P1`?"));
  CHECK(contains(step_faults(R"({"at":"0s","state":{"START":"P3"}})"), "is a symbol and has no states"));
  CHECK(contains(step_faults(R"({"at":"0s","force":{"L_P_AGV":true}})"), "is a device; name one of its symbols"));
  CHECK(
      contains(step_faults(R"({"at":"0s","set":{"START":true,"Start":false}})"), "is repeated in another letter case"));
}

TEST_CASE("A fault in a condition is reported at its location") {
  const std::string faults = step_faults(R"({"at":"0s","expect":"START and L_P_AGV.P9"},{"wait":"START or"})");
  CHECK(contains(faults, "2:40 "));  // P9, not the condition's beginning
  CHECK(contains(faults, "state `P9` of `L_P_AGV` not found"));
  CHECK(contains(faults, "but the condition ends"));
}

TEST_CASE("A step cannot set what a unit or PLC drives, but may force it") {
  CHECK(contains(step_faults(R"({"at":"0s","set":{"L_P_AGV_I_P1":true}})"),
                 "2:19 `\"L_P_AGV_I_P1\"` `L_P_AGV_I_P1` is driven by the device `L_P_AGV`"));
  CHECK(step_faults(R"({"at":"0s","force":{"L_P_AGV_I_P1":true}})") == "");
  CHECK(step_faults(R"({"at":"0s","set":{"L_P_AGV_O_P2":true}})") == "");
  CHECK(contains(step_faults(R"({"at":"0s","set":{"L_P_AGV_O_P2":true}})", true), "use `force` instead"));
  CHECK(step_faults(R"({"at":"0s","force":{"L_P_AGV_O_P2":true},"expect":{"L_P_AGV_O_P2":true}})", true) == "");
}

TEST_CASE("Values out of range for their symbol are reported at the value") {
  CHECK(contains(step_faults(R"({"at":"0s","set":{"START":1}})"),
                 "2:27 `1` expected true or false for a BOOL, but found `1`"));
  CHECK(
      contains(step_faults(R"({"at":"0s","expect":{"SPEED":40000}})"), "2:30 `40000` `40000` is out of range for INT"));
}

TEST_CASE("A wait is the only action of its step") {
  CHECK(contains(step_faults(R"({"wait":"START","set":{"START":true}})"),
                 "2:17 `\"set\"` `set` is not allowed with `wait`"));
  CHECK(contains(step_faults(R"({"wait":"START","expect":"START"})"), "`expect` is not allowed with `wait`"));
}

TEST_CASE("Steps know their lines") {
  const BenchTables tables(kAgv);
  const trace::PlantNames names(tables.rows);
  const auto read =
      scenario::read_scenario("{\"symplant-scenario\":1,\n\"steps\":[{\"at\":\"1s\"},\n\n{\"at\":\"2s\"}]}", names, {});
  REQUIRE(read.scenario);
  CHECK(read.scenario->steps[0].line == 2);
  CHECK(read.scenario->steps[1].line == 4);
}

}  // namespace
}  // namespace symplant::test

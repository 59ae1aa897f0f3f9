// Reading a scenario: what each fault says, and where.
#include "scenario_support.hpp"

namespace symplant::test {
namespace {

/// The faults of a scenario against the vehicle, a lamp and a speed; operations of the vehicle are the PLC's with
/// `carried`.
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
  return faults_text(text, read.faults);
}
std::string step_faults(const std::string& steps, bool carried = false) {
  return faults_of("{\"symplant-scenario\":1,\"steps\":[\n" + steps + "]}", carried);
}

TEST_CASE("a scenario may have comments, a schema, and no step") {
  CHECK(faults_of(R"({"$schema":"x", /* a */ "symplant-scenario":1, // b
                      "steps":[]})") == "");
  CHECK(step_faults(R"({"at":"1s"})") == "");
}

TEST_CASE("another version of the format is told apart from nonsense, and from a plant description") {
  CHECK(faults_of(R"({"symplant-scenario":2,"steps":[{"loop":1}]})") ==
        "1:22 `2` this scenario is of version 2 of the format, this symplant reads version 1\n");
  CHECK(contains(faults_of(R"({"symplant":1,"symbols":[]})"),
                 "`\"symplant\"` this is a plant description and no scenario"));
  CHECK(contains(faults_of(R"({"symplant-scenario":"1","steps":[]})"), "wanted is the version of the format, 1"));
  CHECK(contains(faults_of("[]"), "an array stands here"));
  CHECK(contains(faults_of("{\"steps\":[]}"), "the key `symplant-scenario` is missing"));
  CHECK(contains(faults_of("not JSON"), "1:"));
}

TEST_CASE("unknown keys and wrong shapes are told at their places, and the other steps are read all the same") {
  CHECK(step_faults(R"({"at":"1s","expects":{}},
{"at":1},
{"at":"2s","set":{"NONE":true}})") ==
        "2:12 `\"expects\"` the key `expects` is unknown here, the nearest is `expect`\n"
        "3:7 `1` the number `1` stands here, wanted is a duration such as `1.5s`\n"
        "4:19 `\"NONE\"` there is no symbol `NONE`\n");
  CHECK(contains(step_faults(R"({"at":"1s","set":{"START":[1]}})"), "wanted is true, false, a number"));
  CHECK(contains(step_faults(R"({"at":"1s","at":"2s"})"), "at"));  // a key twice
}

TEST_CASE("a step says once when it is") {
  CHECK(step_faults(R"({"set":{}})") == "2:1 `{` this step does not say when it is, add `at`, `plus` or `wait`\n");
  CHECK(contains(step_faults(R"({"at":"1s","plus":"2s"})"), "2:12 `\"plus\"` `at` says already when this step is"));
  CHECK(contains(step_faults(R"({"wait":"START","plus":"2s"})"), "`plus` says already"));
  CHECK(contains(step_faults(R"({"at":"1s","within":"2s"})"), "2:12 `\"within\"` `within` belongs to a `wait`"));
}

TEST_CASE("durations are as everywhere") {
  CHECK(contains(step_faults(R"({"at":"soon"})"), "2:7 `\"soon\"` `soon` is no duration"));
  CHECK(contains(step_faults(R"({"at":"876001h"})"), "later than 100 years"));
  CHECK(contains(step_faults(R"({"at":"800000h"},{"plus":"800000h"})"), "2:26"));
  CHECK(contains(step_faults(R"({"wait":"START","within":"-1s"})"), "is no duration"));
}

TEST_CASE("an at before the steps above it is a fault, a wait counts nothing") {
  CHECK(step_faults(R"({"at":"2s"},{"plus":"1s"},{"wait":"START"},{"at":"2.9s"})") ==
        "2:50 `\"2.9s\"` this is before the `plus` above, which is at 3 s at the earliest, put the steps into their "
        "order\n");
  CHECK(step_faults(R"({"at":"2s"},{"wait":"START","within":"1h"},{"at":"2s"})") == "");
}

TEST_CASE("names go without regard to the case of ASCII letters, and a missing one says the nearest") {
  CHECK(step_faults(R"({"at":"0s","set":{"start":true},"state":{"l_p_agv":"p2"},"expect":"L_p_AGV.P2"})") == "");
  CHECK(contains(step_faults(R"({"at":"0s","set":{"STRAT":true}})"),
                 "there is no symbol `STRAT`, the nearest is `START`"));
  CHECK(contains(step_faults(R"({"at":"0s","release":["START","STRAT"]})"), "2:31 `\"STRAT\"` there is no symbol"));
  CHECK(contains(step_faults(R"({"at":"0s","state":{"L_P_AGB":"P1"}})"),
                 "2:21 `\"L_P_AGB\"` there is no device `L_P_AGB`, the nearest is `L_P_AGV`"));
  CHECK(contains(step_faults(R"({"at":"0s","state":{"L_P_AGV":"P3"}})"),
                 "2:31 `\"P3\"` there is no state `P3` of `L_P_AGV`, the nearest is `P1`"));
  CHECK(contains(step_faults(R"({"at":"0s","state":{"START":"P3"}})"), "is a symbol and has no states"));
  CHECK(contains(step_faults(R"({"at":"0s","force":{"L_P_AGV":true}})"), "is a device, name one of its symbols"));
  CHECK(contains(step_faults(R"({"at":"0s","set":{"START":true,"Start":false}})"), "stands here twice"));
}

TEST_CASE("a fault within a condition is told at its place there") {
  const std::string faults = step_faults(R"({"at":"0s","expect":"START and L_P_AGV.P9"},{"wait":"START or"})");
  CHECK(contains(faults, "2:40 "));  // P9, not the condition's beginning
  CHECK(contains(faults, "there is no state `P9` of `L_P_AGV`"));
  CHECK(contains(faults, "the condition ends where"));
}

TEST_CASE("what a unit moves is not set, what a PLC writes neither; both may be forced") {
  CHECK(contains(step_faults(R"({"at":"0s","set":{"L_P_AGV_I_P1":true}})"),
                 "2:19 `\"L_P_AGV_I_P1\"` `L_P_AGV_I_P1` is moved by the device `L_P_AGV`"));
  CHECK(step_faults(R"({"at":"0s","force":{"L_P_AGV_I_P1":true}})") == "");
  CHECK(step_faults(R"({"at":"0s","set":{"L_P_AGV_O_P2":true}})") == "");
  CHECK(contains(step_faults(R"({"at":"0s","set":{"L_P_AGV_O_P2":true}})", true), "hold it by `force` instead"));
  CHECK(step_faults(R"({"at":"0s","force":{"L_P_AGV_O_P2":true},"expect":{"L_P_AGV_O_P2":true}})", true) == "");
}

TEST_CASE("values that their symbol cannot have are told at the value") {
  CHECK(contains(step_faults(R"({"at":"0s","set":{"START":1}})"), "2:27 `1` `1` stands here, a BOOL is true or false"));
  CHECK(contains(step_faults(R"({"at":"0s","expect":{"SPEED":40000}})"),
                 "2:30 `40000` `40000` is beyond what INT holds"));
}

TEST_CASE("a wait stands alone") {
  CHECK(contains(step_faults(R"({"wait":"START","set":{"START":true}})"), "2:17 `\"set\"` `set` stands beside `wait`"));
  CHECK(contains(step_faults(R"({"wait":"START","expect":"START"})"), "`expect` stands beside `wait`"));
}

TEST_CASE("steps know their lines") {
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

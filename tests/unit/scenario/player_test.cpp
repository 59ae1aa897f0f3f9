// Acting and expecting: when, in which order, and what another instant is.
#include "scenario_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("A step belongs to the instant of its time, including the first one") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"0s","set":{"L_P_AGV_O_P2":true}},{"at":"1.5s"})");
  CHECK(play.changes() == "0:AGV_O_P2=1 1000:AGV_I_P2=1");  // P1 was left within the instant
  CHECK(play.outcomes() == "dd");
}

TEST_CASE("A `plus` counts from the previous step") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"plus":"250ms","set":{"L_P_AGV_O_P2":true}},{"plus":"500ms","set":{"L_P_AGV_O_P2":false}},
                             {"at":"1s"},{"plus":"1s"})");
  CHECK(play.changes() == "0:AGV_I_P1=1 250:AGV_I_P1=0 250:AGV_O_P2=1 750:AGV_O_P2=0 1250:AGV_I_P2=1");
  CHECK(play.time_of(3) == 2000);
}

TEST_CASE("Steps of one time act in their order before the instant's rounds") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},{"plus":"0s","set":{"L_P_AGV_O_P2":false}},
                             {"at":"1s","state":{"L_P_AGV":"P2"}},{"plus":"0s","state":{"L_P_AGV":"P1"}},{"at":"9s"})");
  CHECK(play.changes() == "0:AGV_I_P1=1");  // the pulse is gone at the end of the instant
}

TEST_CASE("An expect reads the images after the rounds, and a later set acts in another instant of that time") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},
                             {"plus":"0s","expect":{"L_P_AGV_O_P2":true,"L_P_AGV_I_P1":false}},
                             {"plus":"0s","expect":"L_P_AGV.moving"},
                             {"plus":"0s","set":{"L_P_AGV_O_P2":false}},
                             {"plus":"0s","expect":{"L_P_AGV_O_P2":false}},
                             {"at":"2s","expect":"L_P_AGV.P2"})");
  CHECK(play.outcomes() == "dhhdhh");
  CHECK(play.changes() == "0:AGV_I_P1=1 1000:AGV_I_P1=0 1000:AGV_O_P2=1 | 1000:AGV_O_P2=0 2000:AGV_I_P2=1");
}

TEST_CASE("Without an expect between them steps share one instant") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"0s","expect":"L_P_AGV.P1"},{"plus":"1s","set":{"L_P_AGV_O_P2":true}},
                             {"plus":"0s","set":{"L_P_AGV_O_P1":true}},{"plus":"0s"})");
  CHECK(play.changes() == "0:AGV_I_P1=1 1000:AGV_O_P2=1 1000:AGV_O_P1=1");  // both: the vehicle stays
}

TEST_CASE("A step sets symbols, then states, forces, releases, then expects") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"1s","expect":{"L_P_AGV_I_P1":true,"L_P_AGV_I_P2":false,"L_P_AGV_O_P1":true},
                              "release":["L_P_AGV_I_P2"],"force":{"L_P_AGV_I_P1":true,"L_P_AGV_I_P2":true},
                              "state":{"L_P_AGV":"P1"},"set":{"L_P_AGV_O_P1":true}})");
  CHECK(play.outcomes() == "h");
}

TEST_CASE("A device put into a state leaves and enters at once, its outputs follow, its move ends") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},{"plus":"0s","expect":"L_P_AGV.moving"},
                             {"at":"1.5s","set":{"L_P_AGV_O_P2":false},"state":{"L_P_AGV":"P2"}},
                             {"plus":"0s","expect":"L_P_AGV.P2 and L_P_AGV_I_P2"},{"at":"9s","expect":"L_P_AGV.P2"})");
  CHECK(play.outcomes() == "dhdhh");
  CHECK(play.changes() == "0:AGV_I_P1=1 1000:AGV_I_P1=0 1000:AGV_O_P2=1 1500:AGV_I_P2=1 1500:AGV_O_P2=0");
}

TEST_CASE("A disabled device can be put into a state, and stays disabled") {
  const BenchTables tables({"DOOR_I_OPEN1", "DOOR_I_SHUT2", "AGV_I_P1", "AGV_I_P2", "AGV_O_P2"},
                           Reported().disables("DOOR", "OPEN1", "AGV"));
  const Play play(tables, R"({"at":"1s","state":{"L_P_AGV":"P2"},"expect":{"L_P_AGV_I_P2":true}},
                             {"at":"2s","state":{"L_P_AGV":"P1"}},{"at":"3s","set":{"L_P_AGV_O_P2":true}},
                             {"at":"5s","expect":"L_P_AGV.P1"},{"at":"6s","state":{"L_P_DOOR":"SHUT2"}},
                             {"at":"7s","expect":"L_P_AGV.P2"})");
  CHECK(play.outcomes() == "hddhdh");
}

TEST_CASE("A force holds until the release, then the value written meanwhile shows") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"1s","force":{"L_P_AGV_O_P2":false,"L_P_AGV_I_P1":false}},
                             {"at":"2s","set":{"L_P_AGV_O_P2":true}},
                             {"plus":"0s","expect":{"L_P_AGV_O_P2":false,"L_P_AGV_I_P1":false}},
                             {"at":"3s","release":["L_P_AGV_I_P1"]},{"plus":"0s","expect":"L_P_AGV_I_P1"},
                             {"at":"4s","release":["L_P_AGV_O_P2"]},{"plus":"0s","expect":{"L_P_AGV_O_P2":true}},
                             {"at":"5s","expect":"L_P_AGV.P2"})");
  CHECK(play.outcomes() == "ddhdhdhh");
}

TEST_CASE("Numbers of every type are set and compared exactly") {
  const BenchTables tables(
      Reported(),
      {{"SPEED", "", "INT", "0", "%QW1"}, {"COUNT", "", "ULINT", "0", "%IW8"}, {"WEIGHT", "", "REAL", "0.0", "%ID20"}});
  const Play play(tables, R"({"at":"1s","set":{"SPEED":-3,"COUNT":"18446744073709551615","WEIGHT":0.1},
                              "expect":{"speed":-3,"count":"16#FFFF_FFFF_FFFF_FFFF","weight":0.1}},
                             {"plus":"0s","expect":"SPEED < -2 and WEIGHT > 0.09"},
                             {"plus":"0s","expect":{"SPEED":-2,"WEIGHT":0.1000001,"COUNT":1}},
                             {"at":"2s","set":{"WEIGHT":"nan"},"expect":{"WEIGHT":"nan"}})");
  CHECK(play.outcomes() == "hhfh");
  CHECK(contains(play.failures(), "expected COUNT = 1, SPEED = -2, WEIGHT = 0.1000001 at 1 s"));
}

TEST_CASE("A step after the end of the run is not reached, a step at the end still acts") {
  const BenchTables tables(kAgv);
  const std::string steps = R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},{"at":"2s","expect":"L_P_AGV.P2"},
                               {"at":"3s","set":{"L_P_AGV_O_P2":false}},{"at":"3s","expect":{"L_P_AGV_O_P2":false}})";
  CHECK(Play(tables, steps, 2 * kSecond).outcomes() == "dhuu");
  CHECK(Play(tables, steps, 2 * kSecond - 1).outcomes() == "duuu");
  CHECK(Play(tables, steps, 9 * kSecond).outcomes() == "dhdh");
}

TEST_CASE("In real time a step acts in the cycle at or after its time, and plus counts from the time itself") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"105ms","set":{"L_P_AGV_O_P2":true}},{"plus":"10ms","expect":"L_P_AGV.moving"},
                             {"wait":"L_P_AGV.P2"},{"plus":"1ms","set":{"L_P_AGV_O_P2":false}})",
                  5 * kSecond, 10 * kMs);
  CHECK(play.outcomes() == "dhhd");
  CHECK(play.changes() == "0:AGV_I_P1=1 110:AGV_I_P1=0 110:AGV_O_P2=1 1110:AGV_I_P2=1 1120:AGV_O_P2=0");
  CHECK(play.time_of(1) == 115);
  CHECK(play.time_of(2) == 1110);
  CHECK(play.time_of(3) == 1111);
}

}  // namespace
}  // namespace symplant::test

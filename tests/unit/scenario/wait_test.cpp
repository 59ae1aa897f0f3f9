// Waiting: when a wait is met, when it fails, and what counts from it.
#include "scenario_support.hpp"
#include "support/malfunction_bench.hpp"

namespace symplant::test {
namespace {

TEST_CASE("A wait is met at the end of the first instant at which its condition holds, including the current one") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"wait":"L_P_AGV.P1"},{"plus":"500ms","set":{"L_P_AGV_O_P2":true}},
                             {"wait":"not L_P_AGV_I_P1"},{"wait":"L_P_AGV.P2"},{"plus":"100ms","set":{"L_P_AGV_O_P2":false}})");
  CHECK(play.outcomes() == "hdhhd");
  CHECK(play.time_of(0) == 0);
  CHECK(play.time_of(2) == 500);
  CHECK(play.time_of(3) == 1500);
  CHECK(play.time_of(4) == 1600);
}

TEST_CASE("A wait without within fails after 10 s, and plus counts from the end of the waiting") {
  const BenchTables tables(kAgv);
  const Play play(tables,
                  R"({"at":"1s","expect":"L_P_AGV.P1"},{"wait":"L_P_AGV.P2"},{"plus":"1s","set":{"L_P_AGV_O_P2":true}},
                             {"wait":"L_P_AGV.P2","within":"999ms"},{"plus":"0s","expect":"L_P_AGV.moving"})");
  CHECK(play.outcomes() == "hfdfh");
  CHECK(play.time_of(1) == 11000);
  CHECK(play.changes() == "0:AGV_I_P1=1 12000:AGV_I_P1=0 12000:AGV_O_P2=1");
  CHECK(contains(play.failures(),
                 "waited 10 s for `L_P_AGV.P2`, still false at 11 s; L_P_AGV has been in P1 since the start: "
                 "%QX2 (operation P2, symbols.csv:4) has never been on"));
  CHECK(contains(play.failures(),
                 "waited 0.999 s for `L_P_AGV.P2`, still false at 12.999 s; L_P_AGV has been in P1->P2 since 12 s"));
}

TEST_CASE("A change in the last instant of the time still meets the wait") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},{"wait":"L_P_AGV.P2","within":"1s"})");
  CHECK(play.outcomes() == "dh");
  CHECK(play.time_of(1) == 2000);
}

TEST_CASE("A condition that holds only between two steps of a plant is seen by the instant") {
  const BenchTables tables(kAgv);
  // The move takes 1 s, and is seen in the instant of its end although another one starts there.
  const Play play(tables, R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},{"wait":"L_P_AGV_I_P2"},
                             {"plus":"0s","set":{"L_P_AGV_O_P2":false,"L_P_AGV_O_P1":true}},{"wait":"not L_P_AGV_I_P2"})");
  CHECK(play.outcomes() == "dhdh");
  CHECK(
      play.changes() ==
      "0:AGV_I_P1=1 1000:AGV_I_P1=0 1000:AGV_O_P2=1 2000:AGV_I_P2=1 | 2000:AGV_I_P2=0 2000:AGV_O_P2=0 2000:AGV_O_P1=1");
}

TEST_CASE("An at that is past because of a long wait acts at once, and plus counts from that time") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},{"wait":"L_P_AGV.P2"},
                             {"at":"1.5s","set":{"L_P_AGV_O_P2":false}},{"plus":"250ms","set":{"L_P_AGV_O_P1":true}})");
  CHECK(play.time_of(2) == 2000);
  CHECK(play.time_of(3) == 2250);
}

TEST_CASE("A wait cut off by the end of the run is not reached") {
  const BenchTables tables(kAgv);
  const std::string steps =
      R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},{"wait":"L_P_AGV.P2"},{"plus":"0s","expect":"L_P_AGV.P2"})";
  CHECK(Play(tables, steps, 2 * kSecond - 1).outcomes() == "duu");
  CHECK(Play(tables, steps, 2 * kSecond).outcomes() == "dhh");
}

TEST_CASE("In real time a wait is met at its own instant between two cycles, and not after its time") {
  const BenchTables tables(kAgv);
  const std::string steps = R"({"at":"0s","state":{"L_P_AGV":"P1"}},{"at":"100ms","set":{"L_P_AGV_O_P2":true}},)";
  const Play met(tables, steps + R"({"wait":"L_P_AGV.P2","within":"1150ms"})", 5 * kSecond, 300 * kMs);
  CHECK(met.outcomes() == "ddf");  // set in the cycle at 0.3 s, in P2 at 1.3 s; waited from 0.1 s on
  const Play late(tables, steps + R"({"wait":"L_P_AGV.P2","within":"1.2s"},{"plus":"0s"})", 5 * kSecond, 300 * kMs);
  CHECK(late.outcomes() == "ddhd");
  CHECK(late.time_of(2) == 1300);
}

/// A malfunction that starts in a further instant of the time at which the vehicle is in P2, and a part at the sensor.
const FaultyTables& vehicle_at_a_blind_eye() {
  static const FaultyTables tables({"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1", "PE_I_PART"},
                                   R"({"name":"eye","force":{"L_P_PE_I_PART":true},"when":"L_P_AGV.P2"})");
  return tables;
}

TEST_CASE(
    "A wait is met at the end of its first instant although a further instant at that time changes its condition") {
  const Play by_hand(vehicle_at_a_blind_eye(),
                     R"({"at":"1s","state":{"L_P_AGV":"P2"}},{"wait":"L_P_AGV.P2 and not L_P_PE_I_PART","within":"2s"},
                        {"plus":"0s","expect":"L_P_PE_I_PART"})");
  CHECK(by_hand.outcomes() == "dhh");
  CHECK(by_hand.time_of(1) == 1000);
  const Play moving(
      vehicle_at_a_blind_eye(),
      R"({"at":"0s","set":{"L_P_AGV_O_P2":true}},{"wait":"L_P_AGV.P2 and not L_P_PE_I_PART","within":"2s"})");
  CHECK(moving.outcomes() == "dh");
  CHECK(moving.time_of(1) == 1000);
}

TEST_CASE("A wait that begins in the first instant of a plant is met there, also if nothing changes in it") {
  const FaultyTables tables(std::vector<Row>{{"EYE", "X0"}, {"GATE", "X1"}},
                            R"({"name":"eye","force":{"EYE":true},"when":"not GATE"})");
  const Play play(tables, R"({"wait":"not EYE","within":"2s"},{"wait":"EYE","within":"2s"})");
  CHECK(play.outcomes() == "hh");
  CHECK(play.time_of(1) == 0);
}

TEST_CASE("The instant in which a wait is met is the first one of the next wait") {
  const Play play(vehicle_at_a_blind_eye(),
                  R"({"at":"1s","state":{"L_P_AGV":"P2"}},{"wait":"L_P_AGV.P2","within":"2s"},
                     {"wait":"not L_P_PE_I_PART","within":"2s"},{"wait":"L_P_PE_I_PART","within":"2s"},
                     {"wait":"not L_P_PE_I_PART","within":"2s"})");
  CHECK(play.outcomes() == "dhhhf");
  CHECK(play.time_of(3) == 1000);
  CHECK(play.time_of(4) == 3000);
}

TEST_CASE("A check ends the instants of its time: a wait after it does not see the earlier ones") {
  const Play play(vehicle_at_a_blind_eye(), R"({"at":"1s","state":{"L_P_AGV":"P2"},"expect":"L_P_PE_I_PART"},
                                               {"wait":"not L_P_PE_I_PART","within":"2s"})");
  CHECK(play.outcomes() == "hf");
}

}  // namespace
}  // namespace symplant::test

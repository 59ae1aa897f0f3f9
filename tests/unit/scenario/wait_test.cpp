// Waiting: when a wait is met, when it fails, and what counts from it.
#include "scenario_support.hpp"

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

}  // namespace
}  // namespace symplant::test

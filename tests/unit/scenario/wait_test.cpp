// Waiting: when it is met, when it fails, and what counts from it.
#include "scenario_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("a wait is met at the end of the first instant at which its condition holds, the present one included") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"wait":"L_P_AGV.P1"},{"plus":"500ms","set":{"L_P_AGV_O_P2":true}},
                             {"wait":"not L_P_AGV_I_P1"},{"wait":"L_P_AGV.P2"},{"plus":"100ms","set":{"L_P_AGV_O_P2":false}})");
  CHECK(play.outcomes() == "hdhhd");
  CHECK(play.time_of(0) == 0);
  CHECK(play.time_of(2) == 500);
  CHECK(play.time_of(3) == 1500);
  CHECK(play.time_of(4) == 1600);
}

TEST_CASE("a wait without within fails after 10 s, and plus counts from the end of the waiting") {
  const BenchTables tables(kAgv);
  const Play play(tables,
                  R"({"at":"1s","expect":"L_P_AGV.P1"},{"wait":"L_P_AGV.P2"},{"plus":"1s","set":{"L_P_AGV_O_P2":true}},
                             {"wait":"L_P_AGV.P2","within":"999ms"},{"plus":"0s","expect":"L_P_AGV.moving"})");
  CHECK(play.outcomes() == "hfdfh");
  CHECK(play.time_of(1) == 11000);
  CHECK(play.changes() == "0:AGV_I_P1=1 12000:AGV_I_P1=0 12000:AGV_O_P2=1");
  CHECK(contains(play.failures(),
                 "waited 10 s for `L_P_AGV.P2`, in vain until 11 s; L_P_AGV is in P1 since the start, none"));
  CHECK(contains(play.failures(),
                 "waited 0.999 s for `L_P_AGV.P2`, in vain until 12.999 s; L_P_AGV is in P1->P2 since 12 s"));
}

TEST_CASE("what comes in the very instant in which the time is over still meets it") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},{"wait":"L_P_AGV.P2","within":"1s"})");
  CHECK(play.outcomes() == "dh");
  CHECK(play.time_of(1) == 2000);
}

TEST_CASE("a condition that holds only between two steps of a plant is seen by the instant") {
  const BenchTables tables(kAgv);
  // The move takes a second, and is seen in the instant of its end although another one begins there.
  const Play play(tables, R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},{"wait":"L_P_AGV_I_P2"},
                             {"plus":"0s","set":{"L_P_AGV_O_P2":false,"L_P_AGV_O_P1":true}},{"wait":"not L_P_AGV_I_P2"})");
  CHECK(play.outcomes() == "dhdh");
  CHECK(
      play.changes() ==
      "0:AGV_I_P1=1 1000:AGV_I_P1=0 1000:AGV_O_P2=1 2000:AGV_I_P2=1 | 2000:AGV_I_P2=0 2000:AGV_O_P2=0 2000:AGV_O_P1=1");
}

TEST_CASE("an at that is past because a wait took long acts at once, and plus counts from that moment") {
  const BenchTables tables(kAgv);
  const Play play(tables, R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},{"wait":"L_P_AGV.P2"},
                             {"at":"1.5s","set":{"L_P_AGV_O_P2":false}},{"plus":"250ms","set":{"L_P_AGV_O_P1":true}})");
  CHECK(play.time_of(2) == 2000);
  CHECK(play.time_of(3) == 2250);
}

TEST_CASE("a wait that the end of the run cuts off was not reached") {
  const BenchTables tables(kAgv);
  const std::string steps =
      R"({"at":"1s","set":{"L_P_AGV_O_P2":true}},{"wait":"L_P_AGV.P2"},{"plus":"0s","expect":"L_P_AGV.P2"})";
  CHECK(Play(tables, steps, 2 * kSecond - 1).outcomes() == "duu");
  CHECK(Play(tables, steps, 2 * kSecond).outcomes() == "dhh");
}

TEST_CASE("in real time a wait is met at its own instant between two cycles, and not after its time") {
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

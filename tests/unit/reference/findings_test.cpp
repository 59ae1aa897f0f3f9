// Findings of operations and events, requirements, outputs.
#include "bench.hpp"

namespace symplant::test {
namespace {

TEST_CASE("A command without a transition from the unit's state has no effect") {
  Said said;
  said.device("L_P_A").only = true;
  said.device("L_P_A").transitions = {transition("P1", "P2"), transition("P2", "P3")};
  Bench bench({"A_O_P2", "A_O_P3", "A_I_P1", "A_I_P2", "A_I_P3"}, said);
  bench.set("A_O_P3", true).at(0);
  CHECK(bench.findings() == "0:ineffective A_O_P3");
  bench.set("A_O_P3", false).at(1);
  CHECK(bench.findings() == "");  // reported when it rose
}

TEST_CASE("A command that falls before it had an effect is lost") {
  Said said;
  said.device("L_P_A").transitions = {transition("P1", "P2")};
  said.device("L_P_A").transitions[0].when = "L_P_B.ON";
  Bench bench({"A_O_P1", "A_O_P2", "A_I_P1", "A_I_P2", "B_I_ON"}, said);
  bench.set("A_O_P2", true).at(0).set("A_O_P2", false).at(10);
  CHECK(bench.findings() == "10:lost A_O_P2");
  bench.put("B", "ON").set("A_O_P2", true).at(20).set("A_O_P2", false).at(30);
  CHECK(bench.findings() == "");
}

TEST_CASE("A command to the unit's current or target state is not lost") {
  Bench bench({"A_O_P1", "A_O_P2", "A_I_P1", "A_I_P2"});
  bench.set("A_O_P1", true).at(0).set("A_O_P1", false).at(10);
  bench.set("A_O_P2", true).at(20).set("A_O_P2", false).at(30).set("A_O_P2", true).at(40).set("A_O_P2", false).at(50);
  CHECK(bench.findings() == "");
}

TEST_CASE("A command to a disabled unit is reported as such, and not as lost") {
  Said said;
  said.device("L_P_D").disables = {{"ON", {"L_P_A"}}};
  Bench bench({"A_O_P1", "A_O_P2", "A_I_P1", "A_I_P2", "D_I_ON*"}, said);
  bench.set("A_O_P2", true).at(0).set("A_O_P2", false).at(10);
  CHECK(bench.findings() == "0:disabled A_O_P2");
}

TEST_CASE("An event that comes and goes within an instant is too short") {
  Said said;
  said.device("L_P_A").transitions = {automatic("P1", "P2", 10 * kMs), automatic("P2", "P3")};
  Bench bench({"A_I_P1", "A_I_P2", "A_I_P3"}, said);
  bench.at(100);
  CHECK(bench.findings() == "10:short A_I_P2");
}

TEST_CASE("In real time an event that is on for less than a cycle is too short") {
  Said said;
  said.device("L_P_A").transitions = {automatic("P1", "P2", 10 * kMs), automatic("P2", "P3", 4 * kMs),
                                      automatic("P3", "P1", 5 * kMs)};
  Bench bench({"A_I_P1", "A_I_P2", "A_I_P3"}, said);
  bench.plant.reset(0, 5 * kMs);
  bench.at(20);
  CHECK(bench.findings() == "14:short A_I_P2");
}

TEST_CASE("In real time an event that is on for a cycle in which plant time does not advance is not too short") {
  Said said;
  said.device("L_P_A").transitions = {automatic("P1", "P2", 10 * kMs), automatic("P2", "P3", 4 * kMs),
                                      automatic("P3", "P1", 5 * kMs)};
  Bench bench({"A_I_P1", "A_I_P2", "A_I_P3"}, said);
  bench.plant.reset(0, 5 * kMs);
  bench.at(11);
  bench.plant.end_cycle();
  bench.plant.end_cycle();
  bench.at(20);
  CHECK(bench.findings() == "");
}

TEST_CASE("A `never` is violated when its condition becomes true") {
  Said said;
  said.description.requirements = {{"r", "L_P_B.ON", "", "", 0}};
  Bench bench({"B_I_ON*"}, said);
  bench.at(0).put("B", "NOT_ON").at(10).put("B", "ON").at(20);
  CHECK(bench.findings() == "0:violated 0 10:violated 0");
}

TEST_CASE("An `expect` is met within its time, including the end, else violated at its end") {
  Said said;
  said.description.requirements = {{"r", "", "L_P_B.ON", "L_P_C.ON", 100 * kMs}};
  Bench bench({"B_I_ON", "C_I_ON"}, said);
  bench.at(0).put("B", "ON");
  CHECK(bench.at(500).findings() == "100:violated 0");
  bench.put("B", "NOT_ON").at(600).put("B", "ON").at(700 - 1);
  bench.plant.advance_before(700 * kMs);
  bench.put("C", "ON").at(700);
  CHECK(bench.findings() == "");
  CHECK(bench.plant.counters[reference::Counted::watch_met] == 1);
}

TEST_CASE("l_enter and l_leave switch further events after the state's own") {
  Said said;
  said.device("L_P_A").outputs = {{"P2", {{"BUSY", true}}, {{"BUSY", false}}}};
  Bench bench({"A_O_P1", "A_O_P2", "A_I_P1", "A_I_P2", "A_I_BUSY"}, said);
  bench.set("A_O_P2", true).at(0).set("A_O_P2", false).at(1000);
  CHECK(bench.on("A_I_BUSY"));
  bench.set("A_O_P1", true).at(1100);
  CHECK_FALSE(bench.on("A_I_BUSY"));
}

}  // namespace
}  // namespace symplant::test

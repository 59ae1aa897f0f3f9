// Which operations count: arming, `once`, toggling.
#include "bench.hpp"

namespace symplant::test {
namespace {

TEST_CASE("A finished machine does not start again on the old command") {
  Bench bench({"MC_O_RUN2", "MC_I_IDLE1", "MC_I_RUN2"});
  bench.set("MC_O_RUN2", true).at(0).at(1000);
  CHECK(bench.state("MC") == "RUN2");
  bench.at(2000);
  CHECK(bench.state("MC") == "IDLE1");
  CHECK(bench.plant.disarmed(bench.symbol("MC_O_RUN2")));
  bench.at(9000);
  CHECK(bench.state("MC") == "IDLE1");
  bench.set("MC_O_RUN2", false).at(10000);
  CHECK_FALSE(bench.plant.disarmed(bench.symbol("MC_O_RUN2")));
  bench.set("MC_O_RUN2", true).at(11000);
  CHECK(bench.state("MC") == "IDLE1->RUN2");
}

TEST_CASE("An operation is armed again while its unit is disabled") {
  Said said;
  said.device("L_P_DOOR").disables = {{"OPEN", {"L_P_MC"}}};
  said.device("L_P_DOOR").states = {"SHUT"};
  said.device("L_P_DOOR").initial = "SHUT";
  Bench bench({"MC_O_RUN2", "MC_I_IDLE1", "MC_I_RUN2", "DOOR_I_OPEN"}, said);
  bench.set("MC_O_RUN2", true).at(0).at(1000).at(2000);
  bench.put("DOOR", "OPEN").set("MC_O_RUN2", false).at(3000);
  CHECK(bench.state("MC") == "[IDLE1]");
  bench.set("MC_O_RUN2", true).at(4000);
  CHECK(bench.state("MC") == "[IDLE1]");
  bench.put("DOOR", "SHUT").at(4500);
  CHECK(bench.state("MC") == "IDLE1->RUN2");
}

TEST_CASE("An index table with `once` steps once per pulse") {
  Said said;
  said.device("L_P_T").transitions = {transition("P1", "P2", "STEP"), transition("P2", "P3", "STEP"),
                                      transition("P3", "P1", "STEP")};
  for (auto& given : said.device("L_P_T").transitions) given.once = true;
  Bench bench({"T_O_STEP", "T_I_P1", "T_I_P2", "T_I_P3"}, said);
  bench.set("T_O_STEP", true).at(0).at(5000);
  CHECK(bench.state("T") == "P2");
  bench.set("T_O_STEP", false).at(6000).set("T_O_STEP", true).at(7000).at(9000);
  CHECK(bench.state("T") == "P3");
}

TEST_CASE("Without `once` one operation steps a unit repeatedly") {
  Said said;
  said.device("L_P_T").transitions = {transition("P1", "P2", "STEP"), transition("P2", "P1", "STEP")};
  Bench bench({"T_O_STEP", "T_I_P1", "T_I_P2"}, said);
  bench.set("T_O_STEP", true).at(0).at(1500);
  CHECK(bench.state("T") == "P2->P1");
}

TEST_CASE("A unit stays if several states are wanted, its own state counting as one") {
  Bench bench({"A_O_P1", "A_O_P2", "A_O_P3", "A_I_P1", "A_I_P2", "A_I_P3"});
  bench.set("A_O_P2", true).set("A_O_P3", true).at(0);
  CHECK(bench.state("A") == "P1");
  CHECK(bench.findings() == "0:conflicting A");
  bench.set("A_O_P3", false).set("A_O_P1", true).at(1);
  CHECK(bench.state("A") == "P1");
  CHECK(bench.findings() == "1:lost A_O_P3");  // the conflict continued, and is not reported again
  bench.set("A_O_P1", false).at(2);
  CHECK(bench.state("A") == "P1->P2");
}

}  // namespace
}  // namespace symplant::test

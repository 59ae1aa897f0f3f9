// Instants: rounds, `after`, disables, loops, forces, external actions.
#include "bench.hpp"

namespace symplant::test {
namespace {

/// A lamp's state R2 that follows automatically after 100 ms of B.ON, and returns without it.
Said waiting() {
  Said said;
  said.device("L_P_A").transitions = {automatic("P1", "P2", 100 * kMs, "L_P_B.ON")};
  return said;
}
const std::vector<std::string> kWaiting = {"A_I_P1", "A_I_P2", "B_I_ON"};

TEST_CASE("The cause of an `after` must hold without a break") {
  Bench bench(kWaiting, waiting());
  bench.at(0).put("B", "ON").at(10);
  CHECK(bench.plant.next_due() == 100 * kMs);  // external actions act at now()
  bench.at(60).put("B", "NOT_ON").at(70).put("B", "ON").at(80);
  CHECK(bench.at(169).state("A") == "P1");
  CHECK(bench.at(170).state("A") == "P2");
}

TEST_CASE("A break while the unit is disabled does not count, and its time stops") {
  Said said = waiting();
  said.device("L_P_D").disables = {{"ON", {"L_P_A"}}};
  Bench bench({"A_I_P1", "A_I_P2", "B_I_ON", "D_I_ON"}, said);
  bench.put("B", "ON").at(0).at(60).put("D", "ON").at(61);
  bench.put("B", "NOT_ON").at(500).put("B", "ON").at(900);
  bench.put("D", "NOT_ON").at(901);  // acts at 900
  CHECK(bench.at(939).state("A") == "P1");
  CHECK(bench.at(940).state("A") == "P2");
}

TEST_CASE("A disabled unit stops and continues when it is enabled") {
  Said said;
  said.device("L_P_D").disables = {{"ON", {"L_P_A"}}};
  Bench bench({"A_O_P1", "A_O_P2", "A_I_P1", "A_I_P2", "D_I_ON"}, said);
  bench.at(0).set("A_O_P2", true).at(1).at(401).put("D", "ON").at(450);
  CHECK(bench.state("A") == "[P1->P2]");
  CHECK(bench.plant.next_due() == tables::kNever);
  bench.at(5000).put("D", "NOT_ON").at(5000);
  CHECK(bench.findings() == "5000:started A");
  CHECK(bench.at(5599).state("A") == "P1->P2");
  CHECK(bench.at(5600).state("A") == "P2");
}

TEST_CASE("A unit that stops while moving disables no unit, a settled one does even if it is disabled") {
  Said said;
  said.device("L_P_A").disables = {{"P1", {"L_P_B"}}};
  said.device("L_P_C").disables = {{"ON", {"L_P_A"}}};
  Bench bench({"A_O_P2", "A_I_P1", "A_I_P2", "B_I_ON", "C_I_ON"}, said);
  bench.put("C", "ON").at(0);
  CHECK(bench.state("A") == "[P1]");
  CHECK(bench.state("B") == "[NOT_ON]");
  bench.put("C", "NOT_ON").set("A_O_P2", true).at(1).put("C", "ON").at(2);
  CHECK(bench.state("A") == "[P1->P2]");
  CHECK(bench.state("B") == "NOT_ON");
}

TEST_CASE("Units see each other's steps within the instant, in any order") {
  Said said;
  for (const std::string device : {"L_P_A", "L_P_B", "L_P_C"}) said.device(device).states = {"Z9"};
  said.device("L_P_A").transitions = {automatic("S1", "Z9", 0, "L_P_B.Z9")};
  said.device("L_P_B").transitions = {automatic("S1", "Z9", 0, "L_P_C.Z9")};
  said.device("L_P_C").transitions = {automatic("S1", "Z9", 10 * kMs)};
  Bench bench({"A_I_S1", "B_I_S1", "C_I_S1"}, said);
  bench.at(100);
  CHECK(bench.changes() == "0:A_I_S1=1 0:B_I_S1=1 0:C_I_S1=1 10:A_I_S1=0 10:B_I_S1=0 10:C_I_S1=0");
}

TEST_CASE("An instantaneous loop is reported and frozen, other units continue") {
  Said said;
  said.device("L_P_A").transitions = {automatic("P1", "P2"), automatic("P2", "P1")};
  Bench bench({"A_I_P1", "A_I_P2", "B_O_P1", "B_O_P2", "B_I_P1", "B_I_P2"}, said);
  bench.set("B_O_P1", true).at(0);
  CHECK(bench.findings() == "0:loop A");
  bench.set("B_O_P1", false).set("B_O_P2", true).at(0);
  CHECK(bench.plant.unit(bench.index("A")).frozen);
  CHECK(bench.at(1000).state("B") == "P2");
  bench.put("A", "P2").at(2000);
  CHECK(bench.state("A") == "P2");
  bench.plant.reset();
  CHECK_FALSE(bench.plant.unit(bench.index("A")).frozen);
}

TEST_CASE("Two units that trigger each other are one loop") {
  Said said;
  said.device("L_P_A").transitions = {automatic("P1", "P2", 0, "L_P_B.P1"), automatic("P2", "P1", 0, "L_P_B.P2")};
  said.device("L_P_B").transitions = {automatic("P1", "P2", 0, "L_P_A.P2"), automatic("P2", "P1", 0, "L_P_A.P1")};
  Bench bench({"A_I_P1", "A_I_P2", "B_I_P1", "B_I_P2"}, said);
  CHECK(bench.at(0).findings() == "0:loop A+ 0:loop B");
}

TEST_CASE("A long ripple is no loop") {
  Said said;
  std::vector<std::string> names;
  for (int i = 0; i < 230; ++i) {
    const std::string device = "R" + std::to_string(i);
    names.push_back(device + "_I_P1");
    names.push_back(device + "_I_P2");
    const std::string when = i == 0 ? "" : "L_P_R" + std::to_string(i - 1) + ".P2";
    said.device("L_P_" + device).transitions = {automatic("P1", "P2", 0, when)};
  }
  Bench bench(names, said);
  bench.at(0);
  CHECK(bench.state("R229") == "P2");
  CHECK(bench.plant.counters[reference::Counted::rounds_doubled] == 1);
  CHECK(bench.plant.counters[reference::Counted::loop_frozen] == 0);
}

TEST_CASE("A force hides the unit's value until it is released") {
  Bench bench({"A_O_P1", "A_O_P2", "A_I_P1", "A_I_P2"});
  bench.at(0).changes();
  bench.plant.force(bench.symbol("A_I_P1"), 1);
  bench.set("A_O_P2", true).at(1000).at(2000);
  CHECK(bench.changes() == "1000:A_O_P2=1 2000:A_I_P2=1");
  bench.plant.release(bench.symbol("A_I_P1"));
  CHECK(bench.at(3000).changes() == "2000:A_I_P1=0");
}

TEST_CASE("A forced operation keeps its written value") {
  Bench bench({"A_O_P1", "A_O_P2", "A_I_P1", "A_I_P2"});
  bench.plant.force(bench.symbol("A_O_P2"), 0);
  bench.set("A_O_P2", true).at(100);
  CHECK(bench.state("A") == "P1");
  bench.plant.release(bench.symbol("A_O_P2"));
  CHECK(bench.at(100).state("A") == "P1->P2");
}

TEST_CASE("Only a symbol that no unit drives can be set as an input") {
  Bench bench({"A_O_P2", "A_I_P1", "A_I_P2", "B_I_ON"});
  CHECK_FALSE(bench.plant.set_input(bench.symbol("A_O_P2"), 1));
  CHECK_FALSE(bench.plant.set_input(bench.symbol("A_I_P2"), 1));
  CHECK(bench.plant.set_input(bench.symbol("B_I_ON"), 1));
  bench.at(0);
  CHECK(bench.on("B_I_ON"));
  CHECK(bench.state("B") == "NOT_ON");
}

TEST_CASE("Symbols of one address are kept equal") {
  std::vector<Row> rows = bits({"L_P_A_O_P1", "L_P_A_O_P2", "L_P_A_I_P1", "L_P_A_I_P2", "L_P_B_I_ON", "L_P_C_O_ON"});
  rows[4].iec = rows[3].iec;
  rows[5].iec = rows[1].iec;
  Bench bench(Said{}, rows);
  bench.set("C_O_ON", true).at(0).at(1000);
  CHECK(bench.state("A") == "P2");
  CHECK(bench.on("A_I_P2"));
  CHECK(bench.on("B_I_ON"));
}

}  // namespace
}  // namespace symplant::test

// Inverted symbols: levels inside the plant, bits in images, forces, conditions and `Initial`.
#include "bench.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kCylinder = {"A_O_P1", "A_O_P2", "A_I_P1", "A_I_P2"};

Said inverting(std::vector<std::string> names) {
  Said said;
  said.description.inverted = std::move(names);
  return said;
}

TEST_CASE("An inverted operation starts with its bit on, and commands while its bit is off") {
  Bench bench(kCylinder, inverting({"L_P_A_O_P2"}));
  bench.at(0);
  CHECK(bench.changes() == "0:A_O_P2=1 0:A_I_P1=1");
  CHECK(bench.state("A") == "P1");
  bench.set("A_O_P2", false).at(500).set("A_O_P2", true).at(600);
  CHECK(bench.state("A") == "P1->P2");
  CHECK(bench.findings() == "");
  CHECK(bench.at(1500).state("A") == "P2");
}

TEST_CASE("The bit of an inverted event is off while its state is reached") {
  Bench bench(kCylinder, inverting({"l_p_a_i_*"}));
  bench.at(0);
  CHECK(bench.changes() == "0:A_I_P2=1");
  bench.set("A_O_P2", true).at(500).at(1500);
  CHECK(bench.changes() == "500:A_O_P2=1 500:A_I_P1=1 1500:A_I_P2=0");
}

TEST_CASE("Inverted events do not decide the initial state") {
  CHECK(Bench({"A_O_P1", "A_O_P2", "A_I_P1", "A_I_P2*"}).at(0).state("A") == "P2");
  const Said said = inverting({"L_P_A_I_P2"});
  CHECK(Bench({"A_O_P1", "A_O_P2", "A_I_P1", "A_I_P2*"}, said).at(0).state("A") == "P1");
}

TEST_CASE("A condition that names an inverted symbol reads its bit") {
  Said said = inverting({"L_P_A_I_P1", "L_P_A_O_P2"});
  said.description.requirements = {{"event", "L_P_A_I_P1", "", "", 0}, {"operation", "not L_P_A_O_P2", "", "", 0}};
  Bench bench(kCylinder, said);
  CHECK(bench.at(0).findings() == "");
  CHECK(bench.set("A_O_P2", false).at(100).findings() == "100:violated 0 100:violated 1");
}

TEST_CASE("A force on an inverted symbol is a bit") {
  Bench bench(kCylinder, inverting({"L_P_A_O_P2", "L_P_A_I_P1"}));
  bench.plant.force(bench.symbol("A_O_P2"), 0);
  bench.plant.force(bench.symbol("A_I_P1"), 1);
  bench.at(0);
  CHECK(bench.state("A") == "P1->P2");
  CHECK(bench.changes() == "0:A_I_P1=1");
}

TEST_CASE("An inverted event that is no state starts with its Initial as a bit, outputs switch its level") {
  Said said = inverting({"L_P_A_I_BUSY", "L_P_A_I_FREE"});
  said.device("L_P_A").outputs = {{"P2", {{"BUSY", true}, {"FREE", false}}, {}}};
  Bench bench({"A_O_P1", "A_O_P2", "A_I_P1", "A_I_P2", "A_I_BUSY*", "A_I_FREE"}, said);
  bench.at(0);
  CHECK(bench.on("A_I_BUSY"));
  CHECK_FALSE(bench.on("A_I_FREE"));
  bench.set("A_O_P2", true).at(1).at(1001);
  CHECK_FALSE(bench.on("A_I_BUSY"));
  CHECK(bench.on("A_I_FREE"));
}

TEST_CASE("Symbols of one address are equal in bits, each inverted or not") {
  std::vector<Row> rows = bits({"L_P_A_O_P2", "L_P_A_I_P1", "L_P_A_I_P2", "L_P_B_O_ON", "L_P_B_I_ON", "L_P_C_I_ON"});
  rows[3].iec = rows[0].iec;
  rows[5].iec = rows[4].iec;
  Bench bench(inverting({"L_P_B_O_ON", "L_P_B_I_ON"}), rows);
  bench.at(0);
  // The first operation of the address decides how it starts.
  CHECK(bench.changes() == "0:A_I_P1=1 0:B_I_ON=1 0:C_I_ON=1");
  CHECK(bench.state("B") == "NOT_ON->ON");
  bench.at(1000);
  CHECK(bench.state("B") == "ON");
  CHECK(bench.changes() == "1000:B_I_ON=0 1000:C_I_ON=0");
  bench.set("A_O_P2", true).at(1500).at(2000);
  CHECK(bench.state("A") == "P1->P2");
  CHECK(bench.state("B") == "ON->NOT_ON");
  CHECK(bench.changes() == "1500:A_O_P2=1 1500:A_I_P1=0 1500:B_O_ON=1 1500:B_I_ON=1 1500:C_I_ON=1");
}

TEST_CASE("Findings of inverted symbols speak of levels") {
  Said said = inverting({"L_P_A_O_P3", "L_P_A_I_P2"});
  said.device("L_P_A").only = true;
  said.device("L_P_A").transitions = {automatic("P1", "P2", 10 * kMs), automatic("P2", "P3")};
  Bench bench({"A_O_P3", "A_I_P1", "A_I_P2", "A_I_P3"}, said);
  bench.at(5).set("A_O_P3", false).at(6);
  CHECK(bench.findings() == "6:ineffective A_O_P3");
  bench.at(10);
  CHECK(bench.findings() == "10:short A_I_P2");
}

TEST_CASE("At the first instant an inverted operation rises from off, and an inverted event can be too short") {
  Said said = inverting({"L_P_A_O_P2", "L_P_B_I_P1"});
  said.device("L_P_D").disables = {{"ON", {"L_P_A"}}};
  said.device("L_P_B").transitions = {automatic("P1", "P2")};
  Bench bench({"A_O_P2", "A_I_P1", "A_I_P2", "D_I_ON*", "B_I_P1", "B_I_P2"}, said);
  bench.set("A_O_P2", false).at(0);
  CHECK(bench.findings() == "0:disabled A_O_P2 0:short B_I_P1");
}

TEST_CASE("A disarmed inverted operation is one whose bit is off") {
  Bench bench({"MC_O_RUN2", "MC_I_IDLE1", "MC_I_RUN2"}, inverting({"L_P_MC_O_RUN2"}));
  bench.at(0);
  CHECK_FALSE(bench.plant.disarmed(bench.symbol("MC_O_RUN2")));
  bench.set("MC_O_RUN2", false).at(10).at(1010).at(2010);
  CHECK(bench.state("MC") == "IDLE1");
  CHECK(bench.plant.disarmed(bench.symbol("MC_O_RUN2")));
}

TEST_CASE("The digest holds levels of units' symbols, and bits of others") {
  const std::vector<std::string> names = {"A_O_P1", "A_O_P2", "A_I_P1", "A_I_P2"};
  Bench without(names);
  Bench with(names, inverting({"L_P_A_*"}));
  without.at(0);
  with.at(0);
  CHECK(without.plant.state_hash() == with.plant.state_hash());
  std::vector<Row> rows = bits(names);
  rows.push_back({"SPARE", "", "BOOL", "FALSE", "%IX77"});
  Bench spare(Said{}, rows);
  Bench inverted(inverting({"SPARE"}), rows);
  CHECK(spare.at(0).plant.state_hash() == inverted.at(0).plant.state_hash());
}

}  // namespace
}  // namespace symplant::test

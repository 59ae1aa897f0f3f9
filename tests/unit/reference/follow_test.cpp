// Inputs that no device drives and that follow a condition.
#include "bench.hpp"

namespace symplant::test {
namespace {

Said following(std::vector<description::GivenFollow> follow) {
  Said said;
  said.description.follow = std::move(follow);
  return said;
}

TEST_CASE("A symbol that follows takes the truth of its condition, and is in no unit") {
  Bench bench({"A_I_ON", "A_I_READY", "A_O_ON"}, following({{"L_P_A_I_READY", "L_P_A.ON or L_P_A.moving"}}));
  CHECK(bench.analysed.model().units.size() == 1);
  CHECK(bench.analysed.model().units[0].states.size() == 2);
  bench.set("A_O_ON", true).at(10).set("A_O_ON", false).at(2000).at(9000);
  CHECK(bench.changes() == "10:A_I_READY=1 10:A_O_ON=1 1010:A_I_ON=1 2000:A_I_ON=0 2000:A_O_ON=0 3000:A_I_READY=0");
  CHECK(bench.findings() == "");
}

TEST_CASE("A symbol that follows starts off whatever its Initial, and is not set as an input") {
  Bench bench({"A_I_ON", "A_I_READY*"}, following({{"L_P_A_I_READY", "L_P_A.ON"}}));
  CHECK_FALSE(bench.plant.set_input(bench.symbol("A_I_READY"), 1));
  bench.at(0);
  CHECK(bench.changes() == "");
}

TEST_CASE("An inverted symbol that follows has the opposite bit") {
  Said said = following({{"L_P_A_I_READY", "L_P_A.ON"}});
  said.description.inverted = {"L_P_A_I_READY"};
  Bench bench({"A_I_ON", "A_I_READY"}, said);
  bench.at(0).put("A", "ON").at(5).at(10);
  CHECK(bench.changes() == "0:A_I_READY=1 0:A_I_ON=1 0:A_I_READY=0");
}

TEST_CASE("Symbols follow one another round by round, and units see them") {
  Said said = following({{"L_P_F1", "L_P_A.ON"}, {"L_P_F2", "L_P_F1"}, {"L_P_F3", "not L_P_F2"}});
  said.device("L_P_B").transitions = {automatic("P1", "P2", 0, "L_P_F2")};
  Bench bench(said, bits({"L_P_F3", "L_P_F2", "L_P_F1", "L_P_A_I_ON", "L_P_B_I_P1", "L_P_B_I_P2"}));
  bench.at(0);
  CHECK(bench.changes() == "0:F3=1 0:B_I_P1=1");
  bench.put("A", "ON").at(10);
  CHECK(bench.changes() == "0:F3=0 0:F2=1 0:F1=1 0:A_I_ON=1 0:B_I_P1=0 0:B_I_P2=1");
}

TEST_CASE("The entry of a name beats patterns, and the more specific pattern wins") {
  const Said said =
      following({{"L_P_?_I_*", "L_P_A.NOT_ON"}, {"L_P_B_I_*", "L_P_A.ON"}, {"l_p_b_i_x", "L_P_A.moving"}});
  Bench bench({"A_O_ON", "B_I_X", "B_I_Y", "C_I_X"}, said);
  CHECK(bench.at(0).changes() == "0:C_I_X=1");
  CHECK(bench.set("A_O_ON", true).at(10).changes() == "10:A_O_ON=1 10:B_I_X=1 10:C_I_X=0");
  CHECK(bench.at(1010).changes() == "1010:B_I_X=0 1010:B_I_Y=1");
}

TEST_CASE("Symbols that follow read the snapshot of the round, not each other's new values") {
  Bench bench(following({{"L_P_F1", "L_P_A.ON"}, {"L_P_F2", "L_P_F1"}, {"L_P_F3", "L_P_F1 and not L_P_F2"}}),
              bits({"L_P_F1", "L_P_F2", "L_P_F3", "L_P_A_I_ON"}));
  CHECK(bench.at(0).put("A", "ON").at(10).findings() == "0:short F3");
}

TEST_CASE("A force hides a symbol that follows, and others follow the force") {
  Bench bench(following({{"L_P_F1", "L_P_A.ON"}, {"L_P_F2", "L_P_F1"}}), bits({"L_P_F1", "L_P_F2", "L_P_A_I_ON"}));
  bench.plant.force(bench.symbol("F1"), 1);
  CHECK(bench.at(0).changes() == "0:F1=1 0:F2=1");
  bench.plant.release(bench.symbol("F1"));
  CHECK(bench.at(10).changes() == "0:F1=0 0:F2=0");
}

TEST_CASE("Symbols on the address of one that follows have its bit") {
  std::vector<Row> rows = bits({"L_P_G", "L_P_F", "L_P_B_I_ON", "L_P_A_I_ON"});
  rows[0].iec = rows[2].iec = rows[1].iec;
  Bench bench(following({{"L_P_F", "L_P_A.ON"}}), rows);
  CHECK_FALSE(bench.plant.set_input(bench.symbol("G"), 1));
  CHECK_FALSE(bench.plant.set_input(bench.symbol("B_I_ON"), 1));
  CHECK(bench.put("A", "ON").put("B", "ON").at(0).changes() == "0:G=1 0:F=1 0:B_I_ON=1 0:A_I_ON=1");
}

TEST_CASE("A symbol that follows and a unit that reads it can be an instantaneous loop") {
  Said said = following({{"L_P_F1", "L_P_A.P1"}, {"L_P_F2", "L_P_B.ON"}});
  said.device("L_P_A").transitions = {automatic("P1", "P2", 0, "L_P_F1"), automatic("P2", "P1", 0, "not L_P_F1")};
  Bench bench(said, bits({"L_P_F1", "L_P_F2", "L_P_A_I_P1", "L_P_A_I_P2", "L_P_B_I_ON", "L_P_B_O_ON"}));
  bench.at(0);
  CHECK(bench.findings() == "0:loop A+ 0:loop F1");
  CHECK(bench.plant.counters[reference::Counted::follow_frozen] == 1);
  const bool frozen_on = bench.on("F1");
  bench.put("A", frozen_on ? "P2" : "P1").set("B_O_ON", true).at(1000).at(2000);
  CHECK(bench.on("F1") == frozen_on);
  CHECK(bench.on("F2"));
  bench.plant.reset();
  CHECK(bench.at(0).findings() == "0:loop A+ 0:loop F1");
}

TEST_CASE("A symbol that follows and changes twice in an instant is too short") {
  Said said = following({{"L_P_F", "L_P_A.P2"}});
  said.device("L_P_A").transitions = {automatic("P1", "P2", 10 * kMs), automatic("P2", "P3")};
  Bench bench(said, bits({"L_P_F", "L_P_A_I_P1", "L_P_A_I_P2", "L_P_A_I_P3"}));
  CHECK(bench.at(100).findings() == "10:short F 10:short A_I_P2");
}

}  // namespace
}  // namespace symplant::test

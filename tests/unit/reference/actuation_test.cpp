// Each row of the table of moving units.
#include "bench.hpp"

namespace symplant::test {
namespace {

using tables::Actuation;

/// Two states A (rest, initial) and B with an operation and an event each, 1000 ms between them.
Said actuated(Actuation actuation) {
  Said said;
  said.device("L_P_V").actuation = actuation;
  if (actuation == Actuation::spring) said.device("L_P_V").rest = "A1";
  return said;
}

Bench moving(Actuation actuation) { return Bench({"V_O_A1", "V_O_B2", "V_I_A1", "V_I_B2"}, actuated(actuation)); }

/// Sets the operations at 300 ms of a move from A to B that O_B2 started at 0; returns the state then.
std::string at_300(Actuation actuation, bool forth, bool back) {
  Bench bench = moving(actuation);
  bench.set("V_O_B2", true).at(0);
  REQUIRE(bench.state("V") == "A1->B2");
  bench.set("V_O_B2", forth).set("V_O_A1", back).at(300);
  return bench.state("V") + " " + std::to_string(bench.remaining("V"));
}

TEST_CASE("A latched move continues under any command") {
  for (const bool forth : {false, true}) {
    for (const bool back : {false, true}) CHECK(at_300(Actuation::latched, forth, back) == "A1->B2 700");
  }
}

TEST_CASE("A bistable move continues unless only the opposite is commanded") {
  CHECK(at_300(Actuation::bistable, true, false) == "A1->B2 700");
  CHECK(at_300(Actuation::bistable, true, true) == "A1->B2 700");
  CHECK(at_300(Actuation::bistable, false, true) == "B2->A1 300");
  CHECK(at_300(Actuation::bistable, false, false) == "A1->B2 700");
}

TEST_CASE("A held move stops without a command and with both") {
  CHECK(at_300(Actuation::held, true, false) == "A1->B2 700");
  CHECK(at_300(Actuation::held, true, true) == "A1->B2! 700");
  CHECK(at_300(Actuation::held, false, true) == "B2->A1 300");
  CHECK(at_300(Actuation::held, false, false) == "A1->B2! 700");
}

TEST_CASE("A spring reverses to its rest without a command, and stops with both") {
  CHECK(at_300(Actuation::spring, true, false) == "A1->B2 700");
  CHECK(at_300(Actuation::spring, true, true) == "A1->B2! 700");
  CHECK(at_300(Actuation::spring, false, true) == "B2->A1 300");
  CHECK(at_300(Actuation::spring, false, false) == "B2->A1 300");
}

TEST_CASE("A spring that moves to rest continues without a command") {
  Bench bench = moving(Actuation::spring);
  bench.put("V", "B2").at(0);
  CHECK(bench.state("V") == "B2->A1");
  bench.at(400);
  CHECK(bench.remaining("V") == 600);
}

TEST_CASE("Both commands together are conflicting operations, in a move that is not latched") {
  for (const Actuation actuation : {Actuation::latched, Actuation::bistable, Actuation::held, Actuation::spring}) {
    Bench bench = moving(actuation);
    bench.at(0).set("V_O_B2", true).at(10).set("V_O_A1", true).at(300);
    CHECK(bench.findings() == (actuation == Actuation::latched ? "" : "300:conflicting V"));
  }
}

TEST_CASE("A stopped move keeps its time and continues with it") {
  Bench bench = moving(Actuation::held);
  bench.set("V_O_B2", true).at(0).set("V_O_B2", false).at(300).at(5000);
  CHECK(bench.plant.next_due() == tables::kNever);
  bench.set("V_O_B2", true).at(6000).at(6699);
  CHECK(bench.state("V") == "A1->B2");
  CHECK(bench.at(6700).state("V") == "B2");
}

TEST_CASE("A reversed move takes its part of the return time, rounded down") {
  Said said = actuated(Actuation::bistable);
  said.device("L_P_V").transitions = {transition("A1", "B2"), transition("B2", "A1")};
  said.device("L_P_V").transitions[0].takes = description::Duration::fixed(3);
  said.device("L_P_V").transitions[1].takes = description::Duration::fixed(10);
  Bench bench({"V_O_A1", "V_O_B2", "V_I_A1", "V_I_B2"}, said);
  bench.set("V_O_B2", true).at(0).set("V_O_B2", false).set("V_O_A1", true);
  bench.plant.advance_to(1);
  CHECK(bench.state("V") == "B2->A1");
  CHECK(bench.plant.unit(0).remaining == 3);  // 10 * 1 / 3
  bench.set("V_O_B2", true).set("V_O_A1", false);
  bench.plant.advance_to(2);
  CHECK(bench.plant.unit(0).remaining == 2);  // 3 * (10 - 2) / 10
}

TEST_CASE("A spring return takes the time of its transition") {
  Said said;
  said.device("L_P_V").transitions = {transition("ADV", "RET")};
  said.device("L_P_V").transitions[0].takes = description::Duration::fixed(500 * kMs);
  Bench bench({"V_O_ADV", "V_I_ADV", "V_I_RET"}, said);
  bench.set("V_O_ADV", true).at(0).at(1000);
  CHECK(bench.state("V") == "ADV");
  bench.set("V_O_ADV", false).at(2000);
  CHECK(bench.remaining("V") == 500);
  bench.set("V_O_ADV", true).at(2100);
  CHECK(bench.state("V") == "RET->ADV");
  CHECK(bench.remaining("V") == 200);  // 1000 * 100 / 500
}

TEST_CASE("A command for a third state stops a held move, with a finding") {
  Bench bench({"V_O_A1", "V_O_B2", "V_O_C3", "V_I_A1", "V_I_B2", "V_I_C3"}, actuated(Actuation::held));
  bench.at(0).set("V_O_B2", true).at(10).set("V_O_B2", false).set("V_O_C3", true).at(300);
  CHECK(bench.state("V") == "A1->B2!");
  CHECK(bench.findings() == "300:stopped V");
}

TEST_CASE("An automatic move completes with any actuation") {
  Said said = actuated(Actuation::held);
  said.device("L_P_V").transitions = {automatic("B2", "A1")};
  said.device("L_P_V").transitions[0].takes = description::Duration::fixed(100 * kMs);
  Bench bench({"V_O_A1", "V_O_B2", "V_I_A1", "V_I_B2"}, said);
  bench.put("V", "B2").at(0);
  CHECK(bench.state("V") == "B2->A1");
  bench.set("V_O_B2", true).at(50);
  CHECK(bench.remaining("V") == 50);
}

}  // namespace
}  // namespace symplant::test

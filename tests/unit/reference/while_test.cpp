// `while`: a move stops as long as it does not hold.
#include "bench.hpp"

namespace symplant::test {
namespace {

using tables::Actuation;

const std::vector<std::string> kValve = {"V_O_A1", "V_O_B2", "V_I_A1", "V_I_B2", "AIR_I_OK*", "KEY_I_ON"};

/// A1 -> B2 while there is air, B2 -> A1 while the key is on; 1000 ms each.
Said guarded(Actuation actuation) {
  Said said;
  said.device("L_P_V").actuation = actuation;
  if (actuation == Actuation::spring) said.device("L_P_V").rest = "A1";
  said.device("L_P_V").transitions = {transition("A1", "B2"), transition("B2", "A1")};
  said.device("L_P_V").transitions[0].during = "L_P_AIR.OK";
  said.device("L_P_V").transitions[1].during = "L_P_KEY.ON";
  return said;
}

TEST_CASE("A move stops while its `while` does not hold, and keeps its time") {
  for (const Actuation actuation : {Actuation::latched, Actuation::bistable, Actuation::held, Actuation::spring}) {
    Bench bench(kValve, guarded(actuation));
    bench.at(0).set("V_O_B2", true).at(0).at(300).put("AIR", "NOT_OK").at(300);
    CHECK(bench.state("V") == "A1->B2!");
    CHECK(bench.plant.next_due() == tables::kNever);
    bench.at(5000).put("AIR", "OK").at(5000);
    CHECK(bench.state("V") == "A1->B2");
    CHECK(bench.at(5699).state("V") == "A1->B2");
    CHECK(bench.at(5700).state("V") == "B2");
    CHECK(bench.findings() == "");
  }
}

TEST_CASE("A `while` that does not hold does not prevent the start") {
  Bench bench(kValve, guarded(Actuation::latched));
  bench.put("AIR", "NOT_OK").at(0).set("V_O_B2", true).at(100);
  CHECK(bench.state("V") == "A1->B2!");
  CHECK(bench.remaining("V") == 1000);
}

TEST_CASE("A stopped move turns if its actuation allows it, and returns under its own `while`") {
  for (const Actuation actuation : {Actuation::bistable, Actuation::held, Actuation::spring}) {
    Bench bench(kValve, guarded(actuation));
    bench.at(0).set("V_O_B2", true).at(0).at(300).put("AIR", "NOT_OK").at(400);
    CHECK(bench.remaining("V") == 700);
    bench.set("V_O_B2", false).set("V_O_A1", true).at(500);
    CHECK(bench.state("V") == "B2->A1!");
    CHECK(bench.remaining("V") == 300);
    bench.put("KEY", "ON").at(600).at(899);  // acts at 500
    CHECK(bench.state("V") == "A1");
  }
}

TEST_CASE("A latched move does not turn while it is stopped") {
  Bench bench(kValve, guarded(Actuation::latched));
  bench.at(0).set("V_O_B2", true).at(0).at(300).put("AIR", "NOT_OK").at(300);
  CHECK(bench.set("V_O_B2", false).set("V_O_A1", true).at(500).state("V") == "A1->B2!");
}

TEST_CASE("The return of a spring obeys the `while` of the transition that gives its time") {
  Said said;
  said.device("L_P_V").transitions = {transition("ADV", "RET")};
  said.device("L_P_V").transitions[0].takes = description::Duration::fixed(500 * kMs);
  said.device("L_P_V").transitions[0].during = "L_P_AIR.OK";
  Bench bench({"V_O_ADV", "V_I_ADV", "V_I_RET", "AIR_I_OK*"}, said);
  bench.put("V", "ADV").put("AIR", "NOT_OK").at(0);
  CHECK(bench.state("V") == "ADV->RET!");
  bench.set("V_O_ADV", true).at(100);
  CHECK(bench.state("V") == "ADV");  // turned at once, with nothing to travel
  bench.set("V_O_ADV", false).at(200).put("AIR", "OK").at(300).at(500);
  CHECK(bench.state("V") == "ADV->RET");
  CHECK(bench.remaining("V") == 200);  // enabled at 200
  bench.put("AIR", "NOT_OK").at(600);
  CHECK(bench.remaining("V") == 200);
}

TEST_CASE("An automatic move stops by its `while`") {
  Said said;
  said.device("L_P_V").transitions = {automatic("A1", "B2", 100 * kMs)};
  said.device("L_P_V").transitions[0].takes = description::Duration::fixed(50 * kMs);
  said.device("L_P_V").transitions[0].during = "L_P_AIR.OK";
  Bench bench({"V_I_A1", "V_I_B2", "AIR_I_OK*"}, said);
  bench.at(120).put("AIR", "NOT_OK").at(500);
  CHECK(bench.state("V") == "A1->B2!");
  CHECK(bench.remaining("V") == 30);
}

TEST_CASE("A unit without time remaining settles whatever its `while`") {
  Bench bench(kValve, guarded(Actuation::latched));
  bench.set("V_O_B2", true).at(0);
  bench.plant.advance_before(1000 * kMs);
  bench.put("AIR", "NOT_OK").at(1000);
  CHECK(bench.state("V") == "B2");
}

TEST_CASE("Findings of a stopped move are those of its actuation") {
  Bench bench({"V_O_A1", "V_O_B2", "V_O_C3", "V_I_A1", "V_I_B2", "V_I_C3", "AIR_I_OK*", "KEY_I_ON"},
              guarded(Actuation::held));
  bench.at(0).set("V_O_B2", true).at(0).at(300).put("AIR", "NOT_OK").at(300);
  CHECK(bench.findings() == "");
  bench.set("V_O_A1", true).at(400);
  CHECK(bench.findings() == "400:conflicting V");
  bench.set("V_O_B2", false).set("V_O_A1", false).set("V_O_C3", true).at(500);
  CHECK(bench.findings() == "500:stopped V 500:lost V_O_A1");
}

TEST_CASE("A unit that is enabled again but stopped by its `while` has not started") {
  Said said = guarded(Actuation::latched);
  said.device("L_P_D").disables = {{"ON", {"L_P_V"}}};
  std::vector<std::string> names = kValve;
  names.emplace_back("D_I_ON");
  Bench bench(names, said);
  bench.at(0).set("V_O_B2", true).at(0).at(300).put("D", "ON").at(300).put("AIR", "NOT_OK").at(400);
  bench.put("D", "NOT_ON").at(500);
  CHECK(bench.state("V") == "A1->B2!");
  CHECK(bench.findings() == "");
}

TEST_CASE("`when` and `while` of one text are one condition") {
  Said said = guarded(Actuation::latched);
  said.device("L_P_V").transitions[0].when = "L_P_KEY.ON";
  const Bench bench(kValve, said);
  CHECK(bench.analysed.model().units[bench.index("V")].conditions.size() == 2);
}

}  // namespace
}  // namespace symplant::test

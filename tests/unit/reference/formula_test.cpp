// Formulas: how they bind, what their functions give, and what names mean (docs/values.md, "Formulas").
#include "value_bench.hpp"

namespace symplant::test {
namespace {

double result(const std::string& formula) {
  INFO(formula);
  Values plant({is("v", formula), parameter("x", 5), parameter("nan")});
  return plant.at(0)["v"];
}

TEST_CASE("Operators bind from loose to tight, and group from the left") {
  CHECK(result("2 + 3 * 4") == 14);
  CHECK(result("10 - 4 - 3") == 3);
  CHECK(result("24 / 4 / 2") == 3);
  CHECK(result("-2 * -3") == 6);
  CHECK(result("2 - -3") == 5);
  CHECK(result("- (1 + 2)") == -3);
  CHECK(result("1 + 1 = 2") == 1);
  CHECK(result("not 1 = 2") == 1);
  CHECK(result("not 0 and 0") == 0);
  CHECK(result("1 or 0 and 0") == 1);
  CHECK(result("(1 or 0) and 0") == 0);
  CHECK(result("3 >= 3") == 1);
  CHECK(result("3 < 3") == 0);
  CHECK(result("2 and -1") == 1);
  CHECK(result("1e-3 + 0.5") == 0.501);
}

TEST_CASE("NaN compares as false and counts as true") {
  CHECK(result("0 / 0 = 0 / 0") == 0);
  CHECK(result("0 / 0 < 1 or 0 / 0 >= 1") == 0);
  CHECK(result("if(0 / 0, 3, 4)") == 3);
  CHECK(result("not (0 / 0)") == 0);
}

TEST_CASE("Functions") {
  CHECK(result("abs(-3)") == 3);
  CHECK(result("sign(-7) + 10 * sign(2) + 100 * sign(0)") == 9);
  CHECK(result("floor(-1.5) + 10 * ceil(-1.5)") == -12);
  CHECK(result("round(2.5) + 10 * round(3.5)") == 42);
  CHECK(result("sqrt(16)") == 4);
  CHECK(result("exp(0) + ln(1)") == 1);
  CHECK(result("pow(2, 10)") == 1024);
  CHECK(result("mod(-7, 3)") == -1);
  CHECK(result("atan2(0, -1) = pi") == 1);
  CHECK(result("min(3, 1, 2) + 10 * max(3, 1, 7, 2)") == 71);
  CHECK(result("limit(12, 0, 10) + limit(-3, 0, 10)") == 10);
  CHECK(result("wrap(370, 0, 360) + wrap(-10, 0, 360)") == 360);
  CHECK(result("if(x > 4, 1, 2)") == 1);
  CHECK(result("sin(0) + cos(0) + tan(0) + asin(0) + acos(1) + atan(0)") == 1);
}

TEST_CASE("The order of NaN in least and greatest is that of the text") {
  CHECK(result("max(0 / 0, 1) = 1") == 0);
  CHECK(result("max(1, 0 / 0)") == 1);
  CHECK(result("min(1, 0 / 0)") == 1);
  CHECK(result("limit(2, 0, 0 / 0)") == 2);
}

TEST_CASE("A curve is level outside of its points and straight between them") {
  const std::string points = ", 0, 10, 2, 20, 6, 0)";
  CHECK(result("curve(-5" + points) == 10);
  CHECK(result("curve(0" + points) == 10);
  CHECK(result("curve(1" + points) == 15);
  CHECK(result("curve(2" + points) == 20);
  CHECK(result("curve(5" + points) == 5);
  CHECK(result("curve(6" + points) == 0);
  CHECK(result("curve(99" + points) == 0);
  CHECK(result("curve(0, -4, -1, 4, -3)") == -2);
}

TEST_CASE("Names mean values, states, symbols and parts") {
  Said said;
  said.description.plain = {"L_P_B_O_DIR"};
  std::vector<Row> rows = bits({"L_P_B_O_DIR", "L_P_B_O_ON"});
  rows.push_back({"L_P_N", "", "INT", "-7", "%IW40"});
  Values plant({is("states", "l_p_a.HOME1 + 10 * L_P_A.moving"), is("bit", "'L_P_A_I_HOME1'"), is("n", "L_P_N"),
                is("dir", "2 * L_P_B_O_DIR"), is("t", "time")},
               said, rows);
  plant.at(0);
  CHECK(plant["states"] == 1);
  CHECK(plant["bit"] == 1);
  CHECK(plant["n"] == -7);
  plant.bench().set("A_O_WORK2", true).set("B_O_DIR", true);
  plant.at(500 * kMs).at(kSec);
  CHECK(plant["states"] == 10);
  CHECK(plant["bit"] == 0);
  CHECK(plant["dir"] == 2);
  CHECK(plant["t"] == 1);
  plant.plant().force(plant.bench().symbol("N"), 12);
  CHECK(plant.at(2 * kSec)["n"] == 12);
}

TEST_CASE("A formula that names what is not there is a fault") {
  for (const std::string formula : {"nothing", "L_P_A.NOWHERE", "1 +", "1 < 2 < 3", "sqrt(1, 2)", "m", "curve(1, 2)"}) {
    INFO(formula);
    Said said;
    said.description.values = {is("v", formula)};
    const Analysed analysed = analyse_described(bits({"L_P_A_I_ON"}), said.description);
    CHECK(reference::Plant(analysed.model()).difference_from_model() != "");
  }
}

TEST_CASE("Parts have a number and a weight") {
  Said said;
  description::GivenMaterial& material = said.description.material;
  material.kinds = {{"light", 100'000, 1, 0.1}, {"heavy", 100'000, 2, 2.5}};
  material.places = {{"BOX", "", 5, {}}};
  Values plant({is("all", "BOX.parts"), is("heavy", "box.HEAVY"), is("part", "BOX.part"), is("weight", "BOX.weight")},
               said);
  for (const std::uint32_t kind : {1U, 0U, 1U}) CHECK(plant.plant().put({0, tables::kWhole}, kind));
  plant.at(0);
  CHECK(plant["all"] == 3);
  CHECK(plant["heavy"] == 2);
  CHECK(plant["part"] == 3);
  CHECK(plant["weight"] == 2.5 + 0.1 + 2.5);
}

}  // namespace
}  // namespace symplant::test

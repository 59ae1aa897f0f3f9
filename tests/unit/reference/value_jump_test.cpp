// Jumps of values, conditions that compare them, signals, trace lines and state (docs/values.md 4 to 7).
#include <bit>

#include "value_bench.hpp"

namespace symplant::test {
namespace {

using tables::ValueKind;
using Integers = std::vector<std::int64_t>;

description::GivenValue jumping(description::GivenValue given, std::vector<description::GivenChange> changes) {
  given.changes = std::move(changes);
  return given;
}

Row number_row(const std::string& name, const std::string& type, const std::string& address) {
  return {"L_P_" + name, "", type, "", address};
}

description::GivenSignal signal(const std::string& symbol, const std::string& of) {
  description::GivenSignal given;
  given.symbol = symbol;
  given.of = of;
  given.every = kSec;
  return given;
}

Said with_signals(std::vector<description::GivenSignal> signals) {
  Said said;
  said.description.signals = std::move(signals);
  return said;
}

TEST_CASE("A value jumps when a condition begins to hold, not while it holds") {
  Values plant({jumping(parameter("pieces"), {{"L_P_GO", "pieces + 1"}})});
  plant.at(0).bench().set("GO", true);
  CHECK(plant.at(kSec)["pieces"] == 1);
  CHECK(plant.at(2 * kSec)["pieces"] == 1);
  plant.bench().set("GO", false);
  plant.at(3 * kSec).bench().set("GO", true);
  CHECK(plant.at(4 * kSec)["pieces"] == 2);
}

TEST_CASE("Before the first round nothing held") {
  Values plant({jumping(parameter("p"), {{"L_P_A.HOME1", "p + 5"}})});
  CHECK(plant.at(0)["p"] == 5);
}

TEST_CASE("Entries act in order, each on what the one before left") {
  Values plant({jumping(parameter("p", 3), {{"L_P_GO", "p * 2"}, {"L_P_A.HOME1 and L_P_GO", "p + 1"}})});
  plant.at(0).bench().set("GO", true);
  CHECK(plant.at(kSec)["p"] == 7);
}

TEST_CASE("A jump reads other values as they were at the beginning of the round") {
  Values plant({jumping(parameter("a", 1), {{"L_P_GO", "b"}}), jumping(parameter("b", 2), {{"L_P_GO", "a"}})});
  plant.at(0).bench().set("GO", true);
  CHECK(plant.at(kSec)["a"] == 2);
  CHECK(plant["b"] == 1);
}

TEST_CASE("Conditions see a jump in the next round of the instant, formulas at their next computation") {
  Values plant({jumping(parameter("a"), {{"L_P_GO", "4"}}), jumping(parameter("b"), {{"a >= 4", "a"}}), is("c", "a")});
  plant.at(0).bench().set("GO", true);
  plant.at(500 * kMs);
  CHECK(plant["b"] == 4);
  CHECK(plant["c"] == 0);
  CHECK(plant.at(kSec)["c"] == 4);
}

TEST_CASE("An integral steps on from where it jumped, and jumps within its limits") {
  description::GivenValue level = integral("level", "1");
  level.max = 50;
  Values plant({jumping(level, {{"L_P_GO", "40"}, {"level >= 42", "1000"}})});
  plant.at(kSec).bench().set("GO", true);
  plant.at(1500 * kMs);
  CHECK(plant["level"] == 40);
  CHECK(plant.at(2 * kSec)["level"] == 41);
  // The step makes 42, the first round compares it.
  CHECK(plant.at(3 * kSec)["level"] == 50);
}

TEST_CASE("A jump that is not finite changes nothing and begins the finding") {
  Values plant({jumping(integral("x", "1"), {{"L_P_GO", "1 / 0"}})});
  plant.at(kSec).bench().set("GO", true);
  plant.at(1500 * kMs);
  CHECK(plant["x"] == 1);
  CHECK(plant.plant().save().values[0].not_finite);
  plant.at(2 * kSec);
  CHECK_FALSE(plant.plant().save().values[0].not_finite);
  CHECK(plant.findings() == "1:value not finite 0");
}

TEST_CASE("Values that jump without end are frozen, and named as a loop") {
  Values plant({parameter("calm"), jumping(integral("x", "1"), {{"x = 0", "1"}, {"x = 1", "0"}})});
  plant.at(0);
  // One unit and no symbols that follow, tracks or malfunctions come before values.
  CHECK(plant.findings() == "0:instantaneous loop 2");
  CHECK(plant.plant().is_value_frozen("x"));
  CHECK_FALSE(plant.plant().is_value_frozen("calm"));
  const double left = plant["x"];
  CHECK(plant.at(5 * kSec)["x"] == left);
  plant.set("x", 7);
  CHECK(plant.at(6 * kSec)["x"] == 7);
}

TEST_CASE("A loop of values and a unit is one") {
  Said said;
  said.device("L_P_A").transitions = {automatic("HOME1", "WORK2", 0, "L_P_GO"), automatic("WORK2", "HOME1")};
  Values plant({jumping(parameter("n"), {{"L_P_A.WORK2", "n + 1"}})}, said);
  plant.at(0).bench().set("GO", true);
  plant.at(kSec);
  CHECK(plant.findings() == "1:instantaneous loop 0 1:instantaneous loop 1");
  CHECK(plant["n"] > 50);
}

TEST_CASE("Conditions compare two operands") {
  const std::vector<std::string> hold = {"v = 80",
                                         "80 <= v",
                                         "79.5 < v",
                                         "w < v",
                                         "v = w +- 3",
                                         "v = 81 +- 1",
                                         "v > -1",
                                         "-5 < w",
                                         "not v < w",
                                         "L_P_N = 7",
                                         "7.5 > L_P_N",
                                         "v > L_P_N",
                                         "L_P_N < v and (w >= 77 or v = 0)"};
  const std::vector<std::string> fail = {"v = 81 +- 0.5", "v < w", "80 < v", "L_P_N >= 7.5", "v = w +- 2.9"};
  for (const bool expected : {true, false}) {
    for (const std::string& when : expected ? hold : fail) {
      Said said;
      Values plant({parameter("v", 80), parameter("w", 77), jumping(parameter("r"), {{when, "1"}})}, said,
                   {{"L_P_N", "", "INT", "7", "%IW40"}});
      INFO(when);
      CHECK(plant.at(0)["r"] == (expected ? 1 : 0));
    }
  }
}

TEST_CASE("A signal is scaled, rounded half to even and limited by its type") {
  std::vector<description::GivenSignal> signals = {signal("L_P_N1", "level"), signal("L_P_N2", "level"),
                                                   signal("L_P_N3", "level"), signal("L_P_N4", "level - 3.5")};
  signals[1].from = {0, 100};
  signals[1].to = {0, 27648};
  signals[2].limit = {-10, 10};
  Values plant({parameter("level", 2.5)}, with_signals(signals),
               {number_row("N1", "SINT", "%IB40"), number_row("N2", "INT", "%IW50"), number_row("N3", "DINT", "%ID60"),
                number_row("N4", "UINT", "%IW70")});
  const auto shown = [&] {
    return Integers{plant.symbol("N1"), plant.symbol("N2"), plant.symbol("N3"), plant.symbol("N4")};
  };
  plant.at(0);
  CHECK(shown() == Integers{2, 691, 2, 0});  // 691.2; -1 is out of UINT
  plant.set("level", 5.5).at(kSec);
  CHECK(shown() == Integers{6, 1521, 6, 2});  // 1520.64
  plant.set("level", 200).at(2 * kSec);
  CHECK(shown() == Integers{127, 32767, 10, 196});  // 196.5 to even
  plant.set("level", -200).at(3 * kSec);
  CHECK(shown() == Integers{-128, -32768, -10, 0});
}

TEST_CASE("A signal of a real type is the nearest float, and limited to the finite ones") {
  Values plant({parameter("x", 0.1), parameter("y", 10)},
               with_signals({signal("L_P_R", "x"), signal("L_P_L", "x"), signal("L_P_B", "pow(y, 300) / (x - 0.1)")}),
               {number_row("R", "REAL", "%ID40"), number_row("L", "LREAL", "%IL50"), number_row("B", "REAL", "%ID70")});
  const auto real = [&](const std::string& name) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(plant.symbol(name)));
  };
  plant.at(0);
  CHECK(real("R") == static_cast<double>(0.1F));
  CHECK(real("L") == 0.1);
  CHECK(real("B") == static_cast<double>(std::numeric_limits<float>::max()));
}

TEST_CASE("NaN keeps the last number of a signal, 0 at first") {
  Values plant({}, with_signals({signal("L_P_N", "if(time = 0, 0 / 0, if(time = 2, 0 / 0, 10 + time))")}),
               {{"L_P_N", "", "INT", "5", "%IW40"}});
  Integers shown;
  for (int i = 0; i < 4; ++i) {
    plant.at(i * kSec);
    shown.push_back(plant.symbol("N"));
  }
  CHECK(shown == Integers{0, 11, 11, 13});
}

TEST_CASE("Signals show values of their time, are read as they were, and nothing else sets them") {
  Values plant({is("now", "time"), is("shown", "L_P_N")},
               with_signals({signal("L_P_N", "now"), signal("L_P_M", "L_P_N * 10")}),
               {number_row("N", "INT", "%IW40"), number_row("M", "INT", "%IW50")});
  plant.at(0).at(3 * kSec);
  CHECK(plant.symbol("N") == 3);
  CHECK(plant.symbol("M") == 20);
  CHECK(plant["shown"] == 2);
  CHECK_FALSE(plant.plant().set_input(plant.bench().symbol("N"), 1));
}

TEST_CASE("An entry of signals may be a pattern with braces") {
  Values plant({parameter("T1.x", 4), parameter("T2.x", 5)}, with_signals({signal("L_P_T?", "T{1}.x")}),
               {number_row("T1", "INT", "%IW40"), number_row("T2", "INT", "%IW50")});
  plant.at(0);
  CHECK(plant.symbol("T1") == 4);
  CHECK(plant.symbol("T2") == 5);
}

TEST_CASE("A value with `for` is made for each device, and left out where it names what the device lacks") {
  description::GivenValue given =
      is("{self}.level", "3 * {self}.WORK2 + 2 * {self}.HOME1 + 10 * {line}_{process}_A.HOME1");
  given.for_each = "L_P_?";
  Said said;
  said.device("L_P_B").initial = "WORK2";
  Values plant({given}, said, bits({"L_P_B_I_WORK2", "L_P_B_I_HOME1", "L_P_C_I_ON"}));
  plant.at(0);
  CHECK(plant["L_P_A.level"] == 12);
  CHECK(plant["L_P_B.level"] == 13);
  CHECK(is_nan(plant["L_P_C.level"]));
}

TEST_CASE("A trace has values at its times, where they differ from what it has") {
  description::GivenValue quick = integral("quick", "1");
  quick.step = 10 * kMs;
  quick.trace = 50 * kMs;
  description::GivenValue silent = integral("silent", "1");
  silent.trace = 0;
  Values plant({quick, parameter("p", 20.4), silent});
  plant.at(0);
  CHECK(plant.lines() == "0:quick=0 0:p=20.4");
  plant.at(120 * kMs).set("p", 1).at(120 * kMs).set("p", 2).at(150 * kMs);
  CHECK(plant.lines().starts_with("50:quick=0.05"));
  plant.at(210 * kMs);
  CHECK(plant.lines() == "200:quick=" + std::string("0.20000000000000004") + " 200:p=2");
}

TEST_CASE("A trace of a linear model has the outputs that the description names, else the first") {
  description::GivenValue model = value("m", ValueKind::linear);
  model.a = {{1}};
  model.b = {{0}};
  model.c = {{1}, {2}, {3}};
  model.u = {"0"};
  model.start_states = {5};
  description::GivenValue other = model;
  other.name = "o";
  Values plant({model, is("reads", "M[3]"), other});
  plant.at(0);
  CHECK(plant.lines() == "0:m[3]=15 0:reads=15 0:o[1]=5");
}

TEST_CASE("A save has all that values go on from") {
  description::GivenValue late = value("late", ValueKind::delay, "time");
  late.time = 2 * kSec;
  description::GivenValue gust = value("gust", ValueKind::noise);
  gust.noise = 1;
  Values plant({late, gust, jumping(parameter("p"), {{"L_P_GO", "p + 1"}})});
  plant.at(3 * kSec);
  const reference::World saved = plant.plant().save();
  const std::uint64_t hash = plant.plant().state_hash();
  const double gusts = plant.at(5 * kSec)["gust"];
  const std::uint64_t later = plant.plant().state_hash();
  CHECK(later != hash);
  plant.plant().restore(saved);
  CHECK(plant.plant().state_hash() == hash);
  CHECK(plant.at(5 * kSec)["gust"] == gusts);
  CHECK(plant["late"] == 3);
  CHECK(plant.plant().state_hash() == later);
}

}  // namespace
}  // namespace symplant::test

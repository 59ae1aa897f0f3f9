// Every kind of value, with numbers computed by hand (docs/values.md, "When a value is computed").
#include "split_mix.hpp"
#include "value_bench.hpp"

namespace symplant::test {
namespace {

using tables::ValueKind;
using Numbers = std::vector<double>;

TEST_CASE("An integral adds its rate times the step, within its limits") {
  description::GivenValue up = integral("up", "2", 20);
  up.max = 25;
  description::GivenValue down = integral("down", "-4", 10);
  down.min = 0;
  Values plant({up, down});
  CHECK(plant.seconds("up", 5) == Numbers{20, 22, 24, 25, 25});
  plant.plant().reset();
  CHECK(plant.seconds("down", 5) == Numbers{10, 6, 2, 0, 0});
}

TEST_CASE("A value without a step has that of the defaults") {
  description::GivenValue level = integral("level", "3");
  level.step.reset();
  Said said;
  said.description.defaults.step = 20 * kMs;
  Values plant({level}, said);
  CHECK(plant.at(19 * kMs)["level"] == 0);
  CHECK(plant.at(20 * kMs)["level"] == 0.02 * 3);
  CHECK(plant.at(40 * kMs)["level"] == 0.02 * 3 + 0.02 * 3);
}

TEST_CASE("A lag approaches its input by 1 - exp(-h / T) of what is left") {
  description::GivenValue oven = value("oven", ValueKind::lag, "200");
  oven.start = 20;
  oven.time = 90 * kSec;
  Values plant({oven});
  const double a = 1 - std::exp(-1.0 / 90.0);
  const double first = 20 + (200.0 - 20.0) * a;
  CHECK(plant.seconds("oven", 3) == Numbers{20, first, first + (200.0 - first) * a});
  CHECK(first == Catch::Approx(21.98895));
}

TEST_CASE("A ramp moves toward its input by at most `up` and `down` a second") {
  description::GivenValue speed = value("speed", ValueKind::ramp, "target");
  speed.up = "0.5";
  speed.down = "0.25";
  Values plant({parameter("target", 1.25), speed});
  CHECK(plant.seconds("speed", 5) == Numbers{0, 0.5, 1, 1.25, 1.25});
  plant.set("target", 0);
  CHECK(plant.at(5 * kSec)["speed"] == 1.25);  // from the input that was stored at 4 s
  CHECK(plant.at(6 * kSec)["speed"] == 1);
  CHECK(plant.at(10 * kSec)["speed"] == 0);
}

TEST_CASE("A ramp without `down` falls as it rises, and a negative rate is 0") {
  description::GivenValue falls = value("falls", ValueKind::ramp, "-3");
  falls.up = "2";
  description::GivenValue stays = value("stays", ValueKind::ramp, "5");
  stays.up = "-2";
  Values plant({falls, stays});
  CHECK(plant.seconds("falls", 4) == Numbers{0, -2, -3, -3});
  CHECK(plant["stays"] == 0);
}

TEST_CASE("A dead time shows its start, then its input of that time before") {
  description::GivenValue late = value("late", ValueKind::delay, "10 + time");
  late.start = 7;
  late.time = 3 * kSec;
  Values plant({late});
  CHECK(plant.seconds("late", 6) == Numbers{7, 7, 7, 10, 11, 12});
}

TEST_CASE("A dead time stores nothing that is not finite: what it holds comes one step later") {
  description::GivenValue late = value("late", ValueKind::delay, "if(time = 1, 0 / 0, 10 + time)");
  late.start = 7;
  late.time = 3 * kSec;
  Values plant({late});
  CHECK(plant.seconds("late", 8) == Numbers{7, 7, 7, 7, 10, 12, 13, 14});
  CHECK(plant.findings() == "1:value not finite 0");
}

TEST_CASE("A derivative is the difference of its inputs over the step, and 0 at the start") {
  description::GivenValue half = value("half", ValueKind::derivative, "time * time");
  half.step = 500 * kMs;
  Values plant({half});
  CHECK(plant.at(0)["half"] == 0);
  CHECK(plant.at(500 * kMs)["half"] == 0.5);
  CHECK(plant.at(kSec)["half"] == 1.5);
}

TEST_CASE("A derivative is 0 until an input is stored, and keeps what is not finite out") {
  Values plant({value("d", ValueKind::derivative, "if(time < 2, 0 / 0, if(time = 4, 1 / 0, 3 * time))")});
  // 2 s: the first input, 6. 3 s: 9 - 6. 4 s: kept. 5 s: 15 - 9 from the last input that was stored, over one step.
  CHECK(plant.seconds("d", 6) == Numbers{0, 0, 0, 3, 3, 6});
  CHECK(plant.findings() == "0:value not finite 0 4:value not finite 0");
}

TEST_CASE("Values that read others are computed after them, whatever their order in the file") {
  Values plant({is("a", "b + 1"), is("b", "2 * c"), integral("c", "1")});
  CHECK(plant.at(kSec)["c"] == 1);
  CHECK(plant["b"] == 2);
  CHECK(plant["a"] == 3);
}

TEST_CASE("A value that is not due has its last output") {
  description::GivenValue slow = is("slow", "time");
  slow.step = 2 * kSec;
  Values plant({is("copy", "slow"), slow});
  CHECK(plant.seconds("copy", 5) == Numbers{0, 0, 2, 2, 4});
}

TEST_CASE("Steps are made all at once, from the inputs stored one step before") {
  Values plant({integral("x", "y", 1), integral("y", "-x", 0)});
  CHECK(plant.seconds("x", 4) == Numbers{1, 1, 0, -2});
  CHECK(plant["y"] == -2);
}

TEST_CASE("Inputs are stored after the values of the same time are computed") {
  Values plant({integral("sum", "rate"), is("rate", "time + 1")});
  CHECK(plant.seconds("sum", 4) == Numbers{0, 1, 3, 6});
}

TEST_CASE("A position is the number of the state, and of the share of a move") {
  description::GivenValue position = value("pos", ValueKind::position, "l_p_a");
  position.at = {{"home1", 100}, {"WORK2", 300}};
  position.step = 250 * kMs;
  Values plant({position});
  CHECK(plant.at(0)["pos"] == 100);
  plant.bench().set("A_O_WORK2", true);
  plant.at(0);
  CHECK(plant.at(250 * kMs)["pos"] == 150);
  CHECK(plant.at(750 * kMs)["pos"] == 250);
  // Settles in the rounds after the values, whose share is then all of it.
  CHECK(plant.at(kSec)["pos"] == 300);
  plant.bench().set("A_O_WORK2", false).set("A_O_HOME1", true);
  plant.at(1100 * kMs);
  CHECK(plant.at(1250 * kMs)["pos"] == 300 - 200 * 0.15);
}

TEST_CASE("Noise is the standard deviation times a sum of twelve draws") {
  description::GivenValue gust = value("Gust", ValueKind::noise);
  gust.noise = 0.5;
  Values plant({gust});
  plant.plant().reset(9);
  for (std::uint64_t k = 0; k < 3; ++k) {
    const std::uint64_t start = 9 ^ fnv_of("GUST") ^ k;
    std::int64_t sum = 0;
    for (std::uint64_t i = 0; i < 12; ++i) {
      sum += static_cast<std::int64_t>(split_mix_output(start + i * 0x9E3779B97F4A7C15) >> 32);
    }
    const double g = static_cast<double>(sum - (std::int64_t{6} << 32)) / 4294967296.0;
    CHECK(plant.at(static_cast<tables::Time>(k) * kSec)["Gust"] == 0.5 * g);
  }
}

description::GivenValue controller() {
  description::GivenValue given = value("ctl", ValueKind::pid);
  given.of = "actual";
  given.to = "10";
  given.kp = 2;
  given.ti = 4 * kSec;
  given.td = 500 * kMs;
  return given;
}

TEST_CASE("A controller adds its three shares") {
  Values plant({controller(), parameter("actual")});
  CHECK(plant.at(0)["ctl"] == 20);  // e = 10, i = 0
  plant.at(500 * kMs).set("actual", 4);
  CHECK(plant.at(kSec)["ctl"] == 13);      // e = 6, i = 2.5, d = -4
  CHECK(plant.at(2 * kSec)["ctl"] == 20);  // e = 6, i = 4, d = 0
}

TEST_CASE("A controller at its limit does not wind up") {
  description::GivenValue limited = controller();
  limited.max = 15;
  Values plant({limited, parameter("actual")});
  CHECK(plant.seconds("ctl", 4) == Numbers{15, 15, 15, 15});
  plant.set("actual", 9);
  CHECK(plant.at(4 * kSec)["ctl"] == 2 * (1 + 0.0 + 0.5 * -9));
  CHECK(plant.at(5 * kSec)["ctl"] == 2 * (1 + 0.25));
}

description::GivenValue state_space() {
  description::GivenValue given = value("m", ValueKind::linear);
  given.a = {{0.5, 1}, {0, 0.25}};
  given.b = {{1}, {2}};
  given.c = {{2, 0}, {0, 1}};
  given.u = {"3"};
  given.start_states = {4, 8};
  return given;
}

TEST_CASE("A linear model computes its states, then its outputs") {
  Values plant({state_space()});
  // x(0) = 4, 8; x(1) = 2 + 8 + 3, 2 + 6; x(2) = 6.5 + 8 + 3, 2 + 6
  CHECK(plant.seconds("m[1]", 3) == Numbers{8, 26, 35});
  CHECK(plant["m[2]"] == 8);
  CHECK(is_nan(plant["m"]));
}

TEST_CASE("A linear model with d reads its inputs in the same step") {
  description::GivenValue direct = state_space();
  direct.d = {{10}, {0}};
  direct.u = {"1 + time"};
  Values plant({direct});
  // x(1) = 2 + 8 + 1, 2 + 2 by the input of 0 s; its outputs are with that of 1 s.
  CHECK(plant.seconds("m[1]", 2) == Numbers{8 + 10, 22 + 20});
  CHECK(plant["m[2]"] == 4);
}

TEST_CASE("Limits hold for outputs of a linear model, not for its states") {
  description::GivenValue given = state_space();
  given.max = 10;
  Values plant({given});
  CHECK(plant.seconds("m[1]", 3) == Numbers{8, 10, 10});
  CHECK(plant.plant().save().values[0].states == Numbers{17.5, 8});
}

TEST_CASE("Outputs begin at 0, or at their start, within their limits") {
  description::GivenValue given = is("v", "0 / 0");
  given.min = 3;
  Values plant({given, integral("w", "0 / 0", 5)});
  CHECK(plant["v"] == 3);
  CHECK(plant["w"] == 5);
  CHECK(plant.at(3 * kSec)["v"] == 3);
  CHECK(plant["w"] == 5);
  CHECK(plant.findings() == "0:value not finite 0 0:value not finite 1");
}

TEST_CASE("A negative zero becomes 0") {
  Values plant({is("z", "-0")});
  plant.at(0);
  CHECK(std::signbit(plant["z"]) == false);
}

TEST_CASE("A value that is set makes no step in that instant, and steps from there later") {
  Values plant({integral("x", "1")});
  plant.at(2 * kSec).plant().advance_before(3 * kSec);
  plant.set("x", 10);
  CHECK(plant.at(3 * kSec)["x"] == 10);
  CHECK(plant.at(4 * kSec)["x"] == 11);
  plant.at(4500 * kMs).set("x", 50);
  CHECK(plant.at(5 * kSec)["x"] == 51);
  plant.set("x", 60);  // in a further instant of 5 s
  CHECK(plant.at(5 * kSec)["x"] == 60);
  CHECK(plant.at(6 * kSec)["x"] == 61);
}

TEST_CASE("Parameters, integrals, lags and ramps are set within their limits, other kinds are not") {
  description::GivenValue wind = parameter("wind");
  wind.max = 30;
  Values plant({wind, is("calm", "wind")});
  plant.set("WIND", 31);
  CHECK(plant["wind"] == 30);
  CHECK_FALSE(plant.plant().set_value("calm", 1));
  CHECK_FALSE(plant.plant().set_value("storm", 1));
  CHECK(plant.at(0)["calm"] == 30);
}

TEST_CASE("The finding begins with a result that is not finite, and ends with a computation without one") {
  Values plant({is("v", "1 / mod(floor(time / 2), 2)")});
  CHECK(plant.seconds("v", 8) == Numbers{0, 0, 1, 1, 1, 1, 1, 1});
  CHECK(plant.findings() == "0:value not finite 0 4:value not finite 0");
}

TEST_CASE("An integral whose input was not stored makes no step") {
  Values plant({integral("x", "if(time = 2, 0 / 0, 1)")});
  CHECK(plant.seconds("x", 6) == Numbers{0, 1, 2, 2, 3, 4});
  CHECK(plant.findings() == "2:value not finite 0");
}

TEST_CASE("All inputs of a ramp are stored, or none") {
  description::GivenValue ramp = value("r", ValueKind::ramp, "100");
  ramp.up = "if(time = 1, 1 / 0, 1)";
  Values plant({ramp});
  CHECK(plant.seconds("r", 5) == Numbers{0, 1, 1, 2, 3});
  CHECK(plant.findings() == "1:value not finite 0");
}

TEST_CASE("Overflow in a step keeps the output") {
  Values plant({integral("x", "1e308", 1.7e308)});
  CHECK(plant.seconds("x", 3) == Numbers{1.7e308, 1.7e308, 1.7e308});
  CHECK(plant.findings() == "1:value not finite 0");
}

}  // namespace
}  // namespace symplant::test

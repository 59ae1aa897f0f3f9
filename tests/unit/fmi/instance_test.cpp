// One plant in a co-simulation: when things take effect, what an importer sees, what is refused.
#include "symplant/fmi/instance.hpp"

#include <cmath>
#include <limits>

#include "simulation.hpp"

namespace symplant::test {
namespace {

const std::vector<Row> kCylinder = {{"L_P_CYL_O_ADV"}, {"L_P_CYL_I_ADV"}, {"L_P_CYL_I_RET"}};
/// 100 ms out and back.
const std::string kFast = R"("devices": {"L_P_CYL": {"transitions": [{"from": "*", "to": "ADV", "takes": "100ms"},
                                                                   {"from": "*", "to": "RET", "takes": "100ms"}]}})";

constexpr double kNever = std::numeric_limits<double>::infinity();

TEST_CASE("What is set takes effect at the beginning of the next step") {
  Simulation plant(kCylinder, kFast);
  plant.instance.begin();
  CHECK(plant.get("L_P_CYL_I_RET") == 1);
  plant.set("L_P_CYL_O_ADV", 1);
  CHECK(plant.get("L_P_CYL_I_RET") == 1);
  CHECK(plant.get("L_P_CYL_O_ADV") == 1);
  plant.step(50);
  CHECK(plant.get("L_P_CYL_I_RET") == 0);
  CHECK(plant.get("L_P_CYL.moving") == 1);
  CHECK(plant.get("L_P_CYL_I_ADV") == 0);
}

TEST_CASE("A step ends with what happens at its end") {
  Simulation plant(kCylinder, kFast);
  plant.instance.begin();
  plant.set("L_P_CYL_O_ADV", 1).step(99.999999);
  CHECK(plant.get("L_P_CYL_I_ADV") == 0);
  plant.step(0.000001);
  CHECK(plant.get("L_P_CYL_I_ADV") == 1);
  CHECK(plant.get("L_P_CYL.moving") == 0);
}

TEST_CASE("A step of no duration lets what was set take effect") {
  Simulation plant(kCylinder, kFast);
  plant.instance.begin();
  plant.set("L_P_CYL_O_ADV", 1).step(0);
  CHECK(plant.get("L_P_CYL_I_RET") == 0);
  CHECK(plant.instance.time() == 0);
}

TEST_CASE("A state is numbered from 1 in the order of the device's states") {
  Simulation plant(kCylinder, kFast);
  plant.instance.begin();
  const double rest = plant.described.state("L_P_CYL", "RET") + 1;
  const double out = plant.described.state("L_P_CYL", "ADV") + 1;
  CHECK(plant.get("L_P_CYL.state") == rest);
  plant.set("L_P_CYL_O_ADV", 1).step(50);
  CHECK(plant.get("L_P_CYL.state") == rest);  // from which it moves
  plant.step(50);
  CHECK(plant.get("L_P_CYL.state") == out);
}

TEST_CASE("A pulse shorter than a step is held to its end, once, and counted") {
  Simulation plant(kCylinder, kFast + R"(, "malfunctions": [{"name": "blink", "flicker":
      {"symbol": "L_P_CYL_I_ADV", "every": "10ms", "for": "1ms"}}])");
  plant.instance.begin();
  plant.set("blink", 1).step(15);  // on from 10 to 11 ms
  CHECK(plant.get("L_P_CYL_I_ADV") == 1);
  CHECK(plant.get("short pulses") == 1);
  CHECK(plant.instance.held_events() == std::vector{plant.described.symbol("L_P_CYL_I_ADV")});
  plant.set("blink", 0).step(15);
  CHECK(plant.get("L_P_CYL_I_ADV") == 0);
  CHECK(plant.get("short pulses") == 1);
  CHECK(plant.instance.held_events().empty());
  plant.set("blink", 1).step(35);  // three more
  CHECK(plant.get("L_P_CYL_I_ADV") == 1);
  CHECK(plant.get("short pulses") == 4);
}

TEST_CASE("A short pulse after one that is held shows as a pause of one step") {
  Simulation plant(kCylinder, kFast + R"(, "malfunctions": [{"name": "blink", "flicker":
      {"symbol": "L_P_CYL_I_ADV", "every": "10ms", "for": "1ms"}}])");
  plant.instance.begin();
  plant.set("blink", 1).step(10.5);  // it is on at the end
  CHECK(plant.get("L_P_CYL_I_ADV") == 1);
  CHECK(plant.get("short pulses") == 0);
  plant.step(11);  // off at 11, on from 21: a short pause
  CHECK(plant.get("L_P_CYL_I_ADV") == 0);
  CHECK(plant.get("short pulses") == 1);
  plant.step(0.2);  // still on
  CHECK(plant.get("L_P_CYL_I_ADV") == 1);
  CHECK(plant.get("short pulses") == 1);
}

TEST_CASE("Random times follow the seed, also after a reset") {
  const std::string random = R"("devices": {"L_P_CYL": {"transitions": [
      {"from": "*", "to": "ADV", "takes": {"min": "100ms", "max": "900ms"}}]}})";
  Simulation plant(kCylinder, random);
  const auto arrival = [&](int seed) {
    plant.instance.reset();
    plant.set("seed", seed);
    plant.instance.begin();
    plant.set("L_P_CYL_O_ADV", 1);
    int steps = 0;
    while (plant.get("L_P_CYL_I_ADV") == 0) plant.step(1), ++steps;
    return steps;
  };
  const int first = arrival(1);
  CHECK(arrival(2) != first);
  CHECK(arrival(1) == first);
}

TEST_CASE("What is set before the first step holds with the seed that is set after it") {
  Simulation plant(kCylinder, R"("values": {"load": {"unit": "kg", "start": 2, "min": 0, "max": 10}}, "malfunctions": [
      {"name": "jam", "of": "L_P_CYL", "stuck": true}])");
  plant.set("load", 7).set("jam", 1).set("L_P_CYL_O_ADV", 1).set("seed", 3);
  CHECK(plant.get("load") == 7);
  plant.instance.begin();
  CHECK(plant.get("load") == 7);
  plant.step(5000);
  CHECK(plant.get("jam.active") == 1);
  CHECK(plant.get("L_P_CYL_I_RET") == 1);
  CHECK_FALSE(plant.try_set("seed", 4).empty());
}

TEST_CASE("An ordinary malfunction starts and ends by its parameter") {
  Simulation plant(kCylinder, kFast);
  plant.instance.begin();
  plant.set("L_P_CYL_I_ADV stuck on", 1).step(1);
  CHECK(plant.get("L_P_CYL_I_ADV") == 1);
  plant.set("L_P_CYL_I_ADV stuck on", 0).step(1);
  CHECK(plant.get("L_P_CYL_I_ADV") == 0);
  plant.set("L_P_CYL slow", 1).set("L_P_CYL_O_ADV", 1).step(299);
  CHECK(plant.get("L_P_CYL_I_ADV") == 0);
  plant.step(1);
  CHECK(plant.get("L_P_CYL_I_ADV") == 1);
}

TEST_CASE("An event that no device drives has an input, one that is driven has none") {
  Simulation plant({{"L_P_CYL_O_ADV"}, {"L_P_CYL_I_ADV"}, {"L_P_CYL_I_RET"}, {"L_P_START_I_PUSH"}}, kFast);
  CHECK_FALSE(plant.has("L_P_CYL_I_ADV.set"));
  plant.instance.begin();
  plant.set("L_P_START_I_PUSH.set", 1);
  CHECK(plant.get("L_P_START_I_PUSH") == 0);
  plant.step(1);
  CHECK(plant.get("L_P_START_I_PUSH") == 1);
}

TEST_CASE("An operation whose bit is inverted starts with its bit on") {
  Simulation plant(kCylinder, kFast + R"(, "inverted": ["L_P_CYL_O_ADV"])");
  CHECK(plant.get("L_P_CYL_O_ADV") == 1);
  plant.instance.begin();
  plant.step(500);
  CHECK(plant.get("L_P_CYL_I_RET") == 1);
  plant.set("L_P_CYL_O_ADV", 0).step(500);
  CHECK(plant.get("L_P_CYL_I_ADV") == 1);
}

TEST_CASE("Numbers are those of the symbol's type") {
  Simulation plant({{"L_P_T_O_S", "", "SINT", "0", "%QB0"},
                    {"L_P_T_O_U", "", "UINT", "0", "%QW2"},
                    {"L_P_T_O_D", "", "UDINT", "0", "%QD4"},
                    {"L_P_T_O_L", "", "LINT", "0", "%QL8"},
                    {"L_P_T_O_R", "", "REAL", "0", "%QD36"}},
                   R"("name": "t")");
  using fmi::BaseType;
  CHECK(plant.variable("L_P_T_O_S").type == BaseType::integer);
  CHECK(plant.variable("L_P_T_O_U").type == BaseType::integer);
  CHECK(plant.variable("L_P_T_O_D").type == BaseType::real);
  CHECK(plant.variable("L_P_T_O_L").type == BaseType::real);
  CHECK(plant.variable("L_P_T_O_R").type == BaseType::real);
  plant.instance.begin();
  CHECK(plant.set("L_P_T_O_S", -128).get("L_P_T_O_S") == -128);
  CHECK(plant.try_set("L_P_T_O_S", 128) == "128 is out of range for `L_P_T_O_S`, which is SINT");
  CHECK(plant.set("L_P_T_O_U", 65'535).get("L_P_T_O_U") == 65'535);
  CHECK_FALSE(plant.try_set("L_P_T_O_U", -1).empty());
  CHECK(plant.set("L_P_T_O_D", 4'294'967'295.0).get("L_P_T_O_D") == 4'294'967'295.0);
  CHECK_FALSE(plant.try_set("L_P_T_O_D", 4'294'967'296.0).empty());
  CHECK_FALSE(plant.try_set("L_P_T_O_D", 0.5).empty());
  CHECK(plant.set("L_P_T_O_L", -9'223'372'036'854'775'808.0).get("L_P_T_O_L") == -9'223'372'036'854'775'808.0);
  CHECK_FALSE(plant.try_set("L_P_T_O_L", 9'223'372'036'854'775'808.0).empty());
  CHECK(plant.set("L_P_T_O_R", 0.1).get("L_P_T_O_R") == static_cast<double>(0.1F));
  CHECK_FALSE(plant.try_set("L_P_T_O_R", 1e39).empty());
  CHECK(std::isnan(plant.set("L_P_T_O_R", std::numeric_limits<double>::quiet_NaN()).get("L_P_T_O_R")));
  CHECK_FALSE(plant.try_set("L_P_T_O_D", std::numeric_limits<double>::quiet_NaN()).empty());
}

TEST_CASE("Operations on one address have one input, and the others show it") {
  Simulation plant({{"L_P_LAMP_O_ON", "Y0"}, {"L_P_LIGHT_O_ON", "Y0"}}, R"("name": "t")");
  CHECK(fmi::is_settable(plant.variable("L_P_LAMP_O_ON").kind));
  CHECK_FALSE(fmi::is_settable(plant.variable("L_P_LIGHT_O_ON").kind));
  plant.instance.begin();
  plant.set("L_P_LAMP_O_ON", 1).step(1);
  CHECK(plant.get("L_P_LIGHT_O_ON") == 1);
}

TEST_CASE("Parameters, values, parts and violations are variables") {
  Simulation plant({{"L_P_BELT_O_RUN"}, {"L_P_BELT_I_RUN"}, {"L_P_EYE_I_PART"}},
                   R"("values": {"load": {"start": 2, "min": 0, "max": 10}, "double": {"is": "2 * load"}},
     "material": {"kinds": {"box": {"length": "100 mm"}},
                  "tracks": {"belt": {"length": "1 m", "drives": [{"forward": "L_P_BELT.RUN", "speed": "1 m/s"}],
                                      "sensors": [{"symbol": "L_P_EYE_I_PART", "at": "500 mm"}]}},
                  "sources": [{"name": "s", "at": "belt", "kind": "box", "count": 1}]},
     "requirements": [{"name": "light", "never": "load > 5"}])");
  plant.instance.begin();
  plant.step(10);
  CHECK(plant.get("belt.parts") == 1);
  CHECK(plant.get("double") == 4);
  CHECK(plant.get("violated requirements") == 0);
  plant.set("load", 9).step(10);
  CHECK(plant.get("double") == 18);
  CHECK(plant.get("violated requirements") == 1);
  CHECK(plant.try_set("load", 99) == "99 is out of range for `load`, 0 to 10");
  CHECK_FALSE(plant.try_set("load", std::numeric_limits<double>::quiet_NaN()).empty());
  CHECK(plant.get("load") == 9);
  CHECK(plant.try_set("double", 1) == "`double` cannot be set: it is neither an input nor a parameter");
}

TEST_CASE("A step begins where the last one ended") {
  Simulation plant(kCylinder, kFast);
  CHECK(plant.instance.begin_at(100, kNever).empty());
  plant.instance.begin();
  CHECK(plant.instance.step(100, 0.5).empty());
  CHECK(plant.instance.time() == Catch::Approx(100.5));
  CHECK(plant.instance.step(100.5 + 1e-7, 0.5).empty());  // the error of an importer that adds up its steps
  CHECK(plant.instance.step(101.5, 0.5) == "the step begins at 101.5 s, but the last one ended at 101.0000001 s");
  CHECK(plant.instance.step(101, -0.1) == "a step cannot take -0.1 s");
  CHECK_FALSE(plant.instance.step(101, std::numeric_limits<double>::quiet_NaN()).empty());
  CHECK_FALSE(plant.instance.step(101, 1e12).empty());
  CHECK(plant.instance.time() == Catch::Approx(101));
}

TEST_CASE("A step does not end after the stop time") {
  Simulation plant(kCylinder, kFast);
  CHECK(plant.instance.begin_at(2, 1) == "the stop time 1 is before the start time 2");
  CHECK_FALSE(plant.instance.begin_at(kNever, kNever).empty());
  REQUIRE(plant.instance.begin_at(1, 2).empty());
  plant.instance.begin();
  CHECK(plant.instance.step(1, 0.5).empty());
  CHECK(plant.instance.step(1.5, 0.6) == "the step ends at 2.1 s, after the stop time 2 s");
  CHECK(plant.instance.step(1.5, 0.5).empty());
}

TEST_CASE("Steps are exact and in order also when the experiment starts at a date") {
  Simulation plant(kCylinder, kFast);
  double time = 1.7e9;
  CHECK(plant.instance.begin_at(time, kNever).empty());
  plant.instance.begin();
  plant.set("L_P_CYL_O_ADV", 1);
  for (int i = 0; i < 10; ++i, time += 0.01) REQUIRE(plant.instance.step(time, 0.01).empty());
  CHECK(plant.get("L_P_CYL_I_ADV") == 1);
  CHECK(plant.instance.plant().now() == 100 * tables::kMillisecond);
  CHECK_FALSE(plant.instance.step(1.7e9, 0.01).empty());        // again
  CHECK_FALSE(plant.instance.step(time + 0.5, 0.001).empty());  // left out
}

TEST_CASE("Steps of a third of a second do not drift") {
  Simulation plant(kCylinder, kFast);
  plant.instance.begin();
  for (int i = 0; i < 3000; ++i) REQUIRE(plant.instance.step(i / 3.0, 1 / 3.0).empty());
  CHECK(std::abs(plant.instance.plant().now() - 1000 * tables::kSecond) <= 1);
}

TEST_CASE("An importer that repeats what it sets does not end what starts by itself") {
  Simulation plant(kCylinder, R"("malfunctions": [{"name": "jam", "of": "L_P_CYL", "stuck": true,
      "when": "L_P_CYL.moving", "lasts": "5s"}])");
  plant.instance.begin();
  plant.set("L_P_CYL_O_ADV", 1).set("jam", 0).step(100);
  CHECK(plant.get("jam.active") == 1);
  plant.set("L_P_CYL_O_ADV", 1).set("jam", 0).step(100);
  CHECK(plant.get("jam.active") == 1);
  CHECK(plant.get("jam") == 0);
}

TEST_CASE("A number that the plant itself changes is no parameter") {
  Simulation plant(kCylinder, kFast + R"(, "values": {"n": {"changes": [{"when": "L_P_CYL.ADV", "to": "n + 1"}]}})");
  CHECK_FALSE(fmi::is_settable(plant.variable("n").kind));
  plant.instance.begin();
  plant.set("L_P_CYL_O_ADV", 1).step(200);
  CHECK(plant.get("n") == 1);
}

TEST_CASE("The state of an instance can be saved and restored, also before the first step") {
  const std::string members = kFast + R"(, "malfunctions": [{"name": "blink", "flicker":
      {"symbol": "L_P_CYL_I_ADV", "every": "10ms", "for": "1ms"}}])";
  Simulation plant(kCylinder, members);
  CHECK(plant.instance.begin_at(5, kNever).empty());
  plant.set("seed", 4).set("L_P_CYL_O_ADV", 1);
  const fmi::InstanceState early = plant.instance.save();
  plant.instance.begin();
  plant.set("blink", 1).step(15);
  const fmi::InstanceState held = plant.instance.save();
  plant.step(5).set("blink", 0).set("L_P_CYL_O_ADV", 0).step(500);
  REQUIRE(plant.instance.restore(held));
  CHECK(plant.instance.time() == Catch::Approx(5.015));
  CHECK(plant.get("L_P_CYL_I_ADV") == 1);
  CHECK(plant.get("L_P_CYL_O_ADV") == 1);
  CHECK(plant.get("blink") == 1);
  CHECK(plant.get("short pulses") == 1);
  plant.step(4);
  CHECK(plant.get("L_P_CYL_I_ADV") == 0);
  REQUIRE(plant.instance.restore(early));
  CHECK(plant.get("seed") == 4);
  plant.instance.begin();
  plant.step(100);
  CHECK(plant.get("L_P_CYL_I_ADV") == 1);

  Simulation same(kCylinder, members);
  REQUIRE(same.instance.restore(held));
  CHECK(same.instance.time() == Catch::Approx(5.015));
  CHECK(same.get("L_P_CYL_O_ADV") == 1);
  CHECK(same.get("short pulses") == 1);
  CHECK_FALSE(same.try_set("seed", 1).empty());

  Simulation other({{"L_P_CYL_O_ADV"}, {"L_P_CYL_I_ADV"}}, R"("name": "t")");
  CHECK_FALSE(other.instance.restore(held));
}

}  // namespace
}  // namespace symplant::test

// Why a value has its number.
#include "symplant/why/formula_words.hpp"
#include "why_support.hpp"

namespace symplant::test {
namespace {

/// The sentence about a value of the cell at a time, in ms.
std::string asked(const std::string& values, const std::string& name, tables::Time at = 0) {
  const DescribedPlant cell(with_prefix(kCell), "\"values\": {" + values + "}");
  Asked plant(cell);
  plant.set("MC_O_RUN2").to(at);
  return plant.why(name);
}

TEST_CASE("A value is explained by its formula with the numbers in it") {
  CHECK(asked(R"("flow": {"unit": "l/s", "start": 0.25},
                 "level": {"unit": "l", "start": 20, "integral": "2 * L_P_MC_O_RUN2 - flow"})",
              "level", 1000) == "level is 19.75 l: integral of 2 * L_P_MC_O_RUN2 (1) - flow (0.25)\n");
  CHECK(asked(R"("a": {"is": "2 * L_P_AGV.P1 + (L_P_AGV.P2 + 'L_P_AGV'.moving) * pi"})", "a") ==
        "a is 2: 2 * L_P_AGV.P1 (1) + (L_P_AGV.P2 (0) + 'L_P_AGV'.moving (0)) * pi\n");
  CHECK(asked(R"~("a": {"is": "if(time > 3 and not (time < 1), min(time, 2), 5)"})~", "a", 1500) ==
        "a is 5: if(time (1.5) > 3 and not (time < 1), min(time, 2), 5)\n");
}

TEST_CASE("Each kind of value has its words") {
  const std::string in = R"("in": {"start": 7}, )";
  CHECK(asked(R"("in": {"start": 7})", "in") == "in is 7: a parameter\n");
  CHECK(asked(in + R"("x": {"lag": "in", "time": "1s"})", "x") == "x is 0: lag of in (7)\n");
  CHECK(asked(in + R"("x": {"ramp": "in", "up": 2})", "x") == "x is 0: ramp toward in (7), up 2 per second\n");
  CHECK(asked(in + R"("x": {"ramp": "in", "up": "in", "down": 1})", "x") ==
        "x is 0: ramp toward in (7), up in (7) and down 1 per second\n");
  CHECK(asked(in + R"("x": {"delay": "in", "time": "1s"})", "x") == "x is 0: delay by 1 s of in (7)\n");
  CHECK(asked(in + R"("x": {"derivative": "in"})", "x") == "x is 0: derivative of in (7)\n");
  CHECK(asked(in + R"("x": {"pid": {"of": "in", "to": "in + 1", "kp": 2}})", "x") ==
        "x is 2: pid of in (7) to in (7) + 1\n");
  CHECK(contains(asked(R"("x": {"noise": 0.5})", "x"), ": noise with the standard deviation 0.5\n"));
  const std::string boom = R"("boom": {"linear": {"a": [[1]], "b": [[1]], "c": [[1], [2]], "u": ["in"]}})";
  CHECK(asked(in + boom, "boom[2]") == "boom[2] is 0: linear in in (7)\n");
  CHECK(asked(in + boom + R"(, "x": {"is": "boom[1] + boom[2]"})", "x") == "x is 0: boom[1] (0) + boom[2] (0)\n");
  const std::string position = asked(R"("x": {"position": "L_P_AGV", "at": {"P1": 0, "P2": 850}})", "x");
  CHECK(contains(position, "x is 0: position of L_P_AGV\n    L_P_AGV has been in P1"));
}

TEST_CASE("A value at its limit says so, and a parameter that a malfunction holds") {
  CHECK(asked(R"("x": {"max": 3, "is": "5"})", "x") == "x is 3: 5; it is at its `max`\n");
  CHECK(asked(R"("x": {"min": -3, "is": "-5"})", "x") == "x is -3: -5; it is at its `min`\n");
  const DescribedPlant cell(with_prefix(kCell), R"("values": {"wind": {"unit": "m/s"}},
                            "malfunctions": [{"name": "storm", "set": {"wind": 25}}])");
  Asked plant(cell);
  plant.plant.start_malfunction(0);
  plant.to(1);
  CHECK(plant.why("wind") == "wind is 25 m/s: malfunction `storm` holds it\n");
}

TEST_CASE("Without the plant a value that no trace shows has no number") {
  const DescribedPlant cell(with_prefix(kCell), R"("values": {
      "in": {"start": 7, "trace": false}, "x": {"is": "2 * in", "trace": false}})");
  CHECK(Asked(cell).why("x", false) == "x: 2 * in\n");
}

TEST_CASE("Numbers of explanations have about four digits") {
  using why::number_words;
  CHECK(number_words(0) == "0");
  CHECK(number_words(-12345678) == "-12345678");
  CHECK(number_words(21.98765) == "21.99");
  CHECK(number_words(12345.678) == "12345.7");
  CHECK(number_words(0.00012345) == "0.0001234");
  CHECK(number_words(1.23456e12 + 0.5) == "1.235e+12");
}

}  // namespace
}  // namespace symplant::test

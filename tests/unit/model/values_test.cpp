// Values and signals: their names, their order, and what of them contradicts the plant.
#include "elements/value/resolve.hpp"
#include "material_support.hpp"
#include "support/strings.hpp"

namespace symplant::test {
namespace {

std::vector<Row> tank_rows() {
  std::vector<Row> rows = bits({"S_10_PUMP_O_RUN", "S_10_PUMP_I_RUN", "S_10_VALVE_O_OPEN", "S_10_TANK_I_HIGH"});
  rows.push_back({"S_10_TANK_I_LEVEL", "", "INT", "0", "%IW40"});
  rows.push_back({"S_10_TANK_O_SET", "", "INT", "0", "%QW40"});
  return rows;
}

Analysed tank(const std::string& members) { return analyse_described(tank_rows(), read_description(members)); }

std::string value_faults(const std::string& values) { return faults(tank("\"values\": {" + values + "}")); }

/// The names of the values in the order in which those that are computed from others are computed.
std::string order_of(const std::string& values) {
  const Analysed list = tank("\"values\": {" + values + "}");
  CHECK(faults(list) == "");
  std::string names;
  for (const std::uint32_t v : model::value_order(list.model(), nullptr)) names += list.model().values[v].name + " ";
  return names;
}

}  // namespace

TEST_CASE("A value has a name of its kind that nothing else has") {
  CHECK(value_faults(R"("TANK.level": {}, "flow": {})") == "");
  CHECK(value_faults(R"("S_10_PUMP": {})") ==
        "/values/S_10_PUMP: `S_10_PUMP` is also the name of a device; choose another name");
  CHECK(value_faults(R"("s_10_tank_i_high": {})") ==
        "/values/s_10_tank_i_high: `s_10_tank_i_high` is also the name of a symbol; choose another name");
  CHECK(value_faults(R"("a": {}, "A": {})") == "/values/A: `A` is also the name of a value; choose another name");
  CHECK(value_faults(R"("S_10_PUMP.RUN": {})") ==
        "/values/S_10_PUMP.RUN: `S_10_PUMP.RUN` is a state of a device; choose another name");
  CHECK(value_faults(R"("a.parts": {})") == "/values/a.parts: a value cannot end in `.parts`; choose another name");
  CHECK(value_faults(R"("sin": {})") == "/values/sin: `sin` is a word of formulas; choose another name");
  CHECK(value_faults(R"("a b": {})") ==
        "/values/a b: `a b` is not a name of a value; write letters, digits and `_`, joined by dots");
}

TEST_CASE("What a formula names must exist") {
  CHECK(value_faults(R"("level": {}, "x": {"is": "levl + 1"})") ==
        "/values/x/is: symbol `levl` not found; did you mean `level`?");
  CHECK(value_faults(R"("x": {"is": "S_10_PUMP.RUNS"})") ==
        "/values/x/is: state `RUNS` of `S_10_PUMP` not found; did you mean `RUN`?");
}

TEST_CASE("A start is within the limits") {
  CHECK(value_faults(R"("x": {"min": 5})") == "");
  CHECK(value_faults(R"("x": {"min": 5, "start": 4})") ==
        "/values/x/start: `start` is outside of `min` and `max`; write a number between them");
  CHECK(value_faults(R"("x": {"min": 5, "max": 4})") == "/values/x/min: `min` is above `max`; exchange them");
  CHECK(tank(R"("values": {"x": {"min": 5}})").model().values.at(0).row.start == 5);
}

TEST_CASE("A delay has whole steps, and not too many") {
  CHECK(value_faults(R"("x": {"delay": "1", "time": "50ms"})") == "");
  CHECK(value_faults(R"("x": {"delay": "1", "time": "55ms"})") ==
        "/values/x/time: `time` of a delay is a whole multiple of its step; change one of the two");
  CHECK(value_faults(R"("x": {"delay": "1", "time": "11s", "step": "100us"})") ==
        "/values/x/time: `time` is more than 100,000 steps; write a longer `step`");
}

TEST_CASE("The matrices of a linear value fit") {
  const auto with = [](const std::string& members) { return value_faults(R"("x": {"linear": {)" + members + "}}"); };
  CHECK(with(R"("a": [[1]], "b": [[1]], "c": [[1], [2]], "u": ["1"])") == "");
  CHECK(with(R"("a": [[1, 0]], "b": [[1]], "c": [[1]], "u": ["1"])") ==
        "/values/x/linear/a: `a` has as many rows as columns, one for each state");
  CHECK(with(R"("a": [[1]], "b": [[1]], "c": [[1]], "u": ["1", "2"])") ==
        "/values/x/linear/b: `b` has a row for each state and a column for each formula of `u`");
  CHECK(with(R"("a": [[1]], "b": [[1]], "c": [[1, 2]], "u": ["1"])") ==
        "/values/x/linear/c: `c` has a column for each state");
  CHECK(with(R"("a": [[1]], "b": [[1]], "c": [[1]], "d": [[1, 2]], "u": ["1"])") ==
        "/values/x/linear/d: `d` has a row for each row of `c` and a column for each formula of `u`");
}

TEST_CASE("A position has a number for each state") {
  CHECK(value_faults(R"("x": {"position": "S_10_PUMP", "at": {"RUN": 1, "NOT_RUN": 0}})") == "");
  CHECK(value_faults(R"("x": {"position": "S_10_PUMP", "at": {"RUN": 1, "rest": 0}})") == "");
  CHECK(value_faults(R"("x": {"position": "S_10_PUMP", "at": {"RUN": 1}})") ==
        "/values/x/at: state `NOT_RUN` of `S_10_PUMP` has no number; add it to `at`");
  CHECK(value_faults(R"("x": {"position": "S_10_PMP", "at": {}})") ==
        "/values/x/position: device `S_10_PMP` not found; did you mean `S_10_PUMP`?");
}

TEST_CASE("Values are computed after what they read, equals in the order of the file") {
  CHECK(order_of(R"("a": {"is": "b + 1"}, "b": {"is": "c"}, "c": {"noise": 1}, "d": {"is": "1"})") == "c b a d ");
  CHECK(order_of(R"("a": {"is": "x"}, "x": {"integral": "a"}, "b": {"is": "1"})") == "a b ");
}

TEST_CASE("A value that depends on itself at once is a fault that names the circle") {
  CHECK(value_faults(R"("a": {"is": "b + 1"}, "b": {"derivative": "a"})") ==
        "/values/a: `a` depends on itself: `a` reads `b` reads `a`; put an `integral`, `lag`, `ramp` or `delay` into "
        "the circle");
  CHECK(value_faults(R"("a": {"integral": "-1 * a"})") == "");
}

TEST_CASE("An entry with `for` makes a value for each device") {
  const Analysed list = tank(R"("values": {"{self}.flow": {"for": "S_10_*", "is": "{self}.moving"}})");
  CHECK(faults(list) == "");
  std::string names;
  for (const model::Value& value : list.model().values) names += value.name + " ";
  CHECK(names == "S_10_PUMP.flow S_10_VALVE.flow S_10_TANK.flow ");
  CHECK(value_faults(R"("{self}.x": {"is": "1"})") ==
        "/values/{self}.x: names in braces are replaced only with `for`; add `for`, or write the name");
}

TEST_CASE("A signal drives a numeric input that no device drives") {
  const auto with = [](const std::string& symbol) {
    return faults(tank(R"("values": {"x": {}}, "signals": {")" + symbol + R"(": "x"})"));
  };
  CHECK(with("S_10_TANK_I_LEVEL") == "");
  CHECK(
      with("S_10_TANK_I_HIGH") ==
      "/signals/S_10_TANK_I_HIGH: `S_10_TANK_I_HIGH` is not a numeric input of the PLC; a BOOL input that depends on a "
      "value has `follow`");
  CHECK(with("S_10_TANK_O_SET") ==
        "/signals/S_10_TANK_O_SET: `S_10_TANK_O_SET` is not a numeric input of the PLC; a BOOL input that depends on a "
        "value has `follow`");
}

TEST_CASE("The limits of a signal leave numbers of its type") {
  const auto with = [](const std::string& limit) {
    return faults(
        tank(R"("values": {"x": {}}, "signals": {"S_10_TANK_I_LEVEL": {"of": "x", "limit": )" + limit + "}}"));
  };
  const std::string none =
      "/signals/S_10_TANK_I_LEVEL/limit: no number of INT is within `limit`; write limits from -32768 to 32767";
  CHECK(with("[-1e9, -32768]") == "");
  CHECK(with("[40000, 50000]") == none);
  CHECK(with("[0.2, 0.8]") == none);
}

TEST_CASE("Conditions compare values") {
  const auto with = [](const std::string& condition) {
    return faults(tank(R"("values": {"x": {}}, "follow": {"S_10_TANK_I_HIGH": ")" + condition + "\"}"));
  };
  CHECK(with("x > 3") == "");
  CHECK(with("3 < x and x <= S_10_TANK_O_SET") == "");
  CHECK(with("x = 80 +- 1") == "");
  CHECK(with("y > 3") != "");
}

TEST_CASE("A switch with hysteresis has two conditions, each resolved where it is written") {
  const auto follow = [](const std::string& entries) {
    return faults(tank(R"("values": {"x": {}}, "follow": {)" + entries + "}"));
  };
  const Analysed plant =
      tank(R"("values": {"x": {}}, "follow": {"S_10_TANK_I_HIGH": {"on": "x > 8", "off": "x < 7"}})");
  CHECK(faults(plant) == "");
  REQUIRE(plant.model().follows.size() == 1);
  CHECK(plant.model().follows[0].off);
  CHECK(follow(R"("S_10_TANK_I_HIGH": {"on": "y > 8", "off": "x < 7"})") ==
        "/follow/S_10_TANK_I_HIGH/on: symbol `y` not found; did you mean `x`?");
  CHECK(follow(R"("S_10_TANK_I_HIGH": {"on": "x > 8", "off": "y < 7"})") ==
        "/follow/S_10_TANK_I_HIGH/off: symbol `y` not found; did you mean `x`?");
}

TEST_CASE("Patterns of one rank that switch a symbol off by different conditions contradict each other") {
  const std::string text = faults(tank(
      R"("values": {"x": {}}, "follow": {"S_10_TANK_I_*H": {"on": "x > 3", "off": "x < 2"},
                                         "S_10_TANK_I_H*": {"on": "x > 3", "off": "x < 1"}})"));
  CHECK(contains(text, "are equally specific and give `S_10_TANK_I_HIGH` different conditions"));
}

TEST_CASE("The formula of a time is resolved where it is written") {
  const auto takes = [](const std::string& formula) {
    return faults(tank(R"("values": {"load": {}}, "devices": {"S_10_PUMP": {"transitions": [
        {"from": "*", "to": "RUN", "takes": {"seconds": ")" +
                       formula + "\"}}]}}"));
  };
  CHECK(takes("0.1 * load + 1") == "");
  CHECK(takes("0.1 * laod") ==
        "/devices/S_10_PUMP/transitions/0/takes/seconds: symbol `laod` not found; did you mean `load`?");
  CHECK(contains(takes("0.1 *"), "/devices/S_10_PUMP/transitions/0/takes/seconds: "));
}

}  // namespace symplant::test

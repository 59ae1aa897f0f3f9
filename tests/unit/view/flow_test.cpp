// The signal flow in words: boxes, arrows, what is cut, and what some devices show of it.
#include "flow_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("The signal flow has a box for each value, for what formulas read, and for what reads values") {
  CHECK(boxes_text(flow_of(tank_with_values())) == R"(source | S_T_PUMP | device: RUN
source | S_T_VALVE | device: OPEN
source | S_T_AXIS | device
source | S_T_MIX | device: ON, moving
source | S_T_RESET_O_ON | operation, BOOL
source | S_T_TANK_O_SET | operation, INT
source | FIX | place: weight, parts
source | time | plant time in seconds
value | level [l] | integral, from 0 to 100 | 2 * S_T_PUMP.RUN - outflow - leak
value | outflow [l/s] | is | 0.3 * sqrt(level) * S_T_VALVE.OPEN
value | leak [l/s] | parameter, starts at 0, at least 0
value | temp [degC] | lag, time 90 s | 20 + 5 * heat - 0.01 * temp * curve( ...
value | heat | pid, kp 4, ti 60 s, from 0 to 100 | of temp to S_T_TANK_O_SET
value | speed | ramp | 0.5 * (S_T_MIX.ON or S_T_MIX.moving) ...
value | load | is | FIX.weight + FIX.parts + 0.1 * time
value | pos [mm] | position | S_T_AXIS: IN 0, OUT 850
value | cycles | parameter, starts at 0 | when S_T_RESET_O_ON to 0 | and 2 more jumps
sink | S_T_TANK_I_LEVEL | signal: event, INT | level, from 0 to 100 as 0 to 27648, ...
sink | S_T_TANK_I_TEMP | signal: event, REAL | temp + 0 * S_T_PUMP.RUN, each 10 ms
sink | S_T_TANK_I_HIGH | follows | level > 90 and S_T_VALVE.OPEN
sink | S_T_MIX | device
sink | CV | track
)");
}

TEST_CASE("A switch with hysteresis is shown with both conditions, also if only the second one reads a value") {
  const CompiledText plant = plant_with_values(
      R"("values": {"level": {}}, "follow": {"S_T_TANK_I_HIGH": {"on": "S_T_VALVE.OPEN", "off": "level < 7"}})");
  CHECK(contains(boxes_text(flow_of(plant)), "sink | S_T_TANK_I_HIGH | follows | S_T_VALVE.OPEN; off: level < 7\n"));
  CHECK(contains(arrows_text(flow_of(plant)), "level ..> S_T_TANK_I_HIGH\n"));
  CHECK(contains(render(plant, "table").text, "  S_T_TANK_I_HIGH: S_T_VALVE.OPEN; off: level < 7\n"));
}

TEST_CASE("An arrow leads from what is read to what reads it, once, and is dotted if only conditions read it") {
  CHECK(arrows_text(flow_of(tank_with_values())) == R"(S_T_PUMP -> level [l]
outflow [l/s] -> level [l]
leak [l/s] -> level [l]
level [l] -> outflow [l/s]
S_T_VALVE -> outflow [l/s]
heat -> temp [degC]
temp [degC] -> temp [degC]
level [l] -> temp [degC]
temp [degC] -> heat
S_T_TANK_O_SET -> heat
S_T_MIX -> speed
FIX -> load
time -> load
S_T_AXIS -> pos [mm]
S_T_RESET_O_ON ..> cycles
pos [mm] ..> cycles
cycles -> cycles
load ..> cycles
level [l] -> S_T_TANK_I_LEVEL
temp [degC] -> S_T_TANK_I_TEMP
S_T_PUMP -> S_T_TANK_I_TEMP
level [l] ..> S_T_TANK_I_HIGH
S_T_VALVE ..> S_T_TANK_I_HIGH
level [l] ..> S_T_MIX
speed -> CV
)");
}

TEST_CASE("A plant without values and signals has no signal flow") {
  CHECK(flow_of(described_cell()).empty());
  CHECK(flow_of(plant_with_material()).empty());
  for (const std::string format : {"svg", "dot", "mermaid"}) {
    CHECK_FALSE(contains(render(described_cell(), format).text, "values"));
  }
}

TEST_CASE("A long text is cut after a whole character, and is whole in the tooltip") {
  std::string sum = "1";
  for (int i = 0; i < 30; ++i) sum += " + 1000";
  std::vector<Row> rows = flow_rows();
  const std::string name = "S_T_\xC3\x84\xC3\x96\xC3\x9C\xC3\x84\xC3\x96\xC3\x9C_I_" + std::string(60, 'X');
  rows.push_back({name, "", "INT", "0", "%IW60"});
  const view::Flow flow = flow_of(
      plant_with_values(R"("values": {"x": {"is": ")" + sum + R"("}}, "signals": {")" + name + R"(": "x"})", rows));
  REQUIRE(flow.boxes.size() == 2);
  CHECK(flow.boxes[0].lines == std::vector<std::string>{"x", "is", "1 + 1000 + 1000 + 1000 + 1000 + 1000 ..."});
  CHECK(flow.boxes[0].whole == std::vector<std::string>{"x", "is " + sum + ", each 10 ms"});
  CHECK(flow.boxes[1].lines[0] == name.substr(0, name.size() - 17) + " ...");
  CHECK(flow.boxes[1].whole.front() == name);
}

TEST_CASE("Two jumps are shown, more are counted") {
  const std::string begin = R"("values": {"n": {"changes": [)";
  const std::string jump = R"({"when": "S_T_RESET_O_ON", "to": "n + 1"})";
  const view::Flow two = flow_of(plant_with_values(begin + jump + "," + jump + "]}}"));
  CHECK(two.boxes[1].lines.size() == 4);
  CHECK(two.boxes[1].lines[3] == "when S_T_RESET_O_ON to n + 1");
  CHECK(two.boxes[1].whole.empty());
  const view::Flow four = flow_of(plant_with_values(begin + jump + "," + jump + "," + jump + "," + jump + "]}}"));
  CHECK(four.boxes[1].lines ==
        std::vector<std::string>{"n", "parameter, starts at 0", "when S_T_RESET_O_ON to n + 1", "and 3 more jumps"});
  CHECK_FALSE(four.boxes[1].whole.empty());
}

TEST_CASE("Some devices show only the values that concern them") {
  const CompiledText plant = tank_with_values();
  const auto unit = [&](const std::string& path) {
    for (std::uint32_t u = 0; u < plant.plant().units.size(); ++u) {
      if (plant.plant().units[u].path == path) return u;
    }
    FAIL("no device " << path);
    return 0U;
  };
  CHECK(arrows_text(flow_of(plant, {unit("S_T_AXIS")}, {}, false)) == "S_T_AXIS -> pos [mm]\n");
  CHECK(arrows_text(flow_of(plant, {}, {1}, false)) == "FIX -> load\ntime -> load\n");
  CHECK(arrows_text(flow_of(plant, {unit("S_T_RESET")}, {}, false)) == "S_T_RESET_O_ON ..> cycles\ncycles -> cycles\n");
  CHECK(flow_of(plant_with_values(R"("values": {"x": {}})"), {0}, {}, false).empty());
}

TEST_CASE("A value that a pattern makes is shown with its device") {
  const CompiledText plant = plant_with_values(R"("values": {"{self}.wear": {"for": "S_T_*", "integral": "1"}})");
  const view::Flow flow = flow_of(plant, {0}, {}, false);
  REQUIRE(flow.boxes.size() == 1);
  CHECK(flow.boxes[0].lines[0] == "S_T_PUMP.wear");
}

TEST_CASE("A signal of devices alone is in the signal flow") {
  const CompiledText plant = plant_with_values(R"("signals": {"S_T_TANK_I_LEVEL": "5 * S_T_PUMP.RUN"})");
  CHECK(arrows_text(flow_of(plant)) == "S_T_PUMP -> S_T_TANK_I_LEVEL\n");
  CHECK(arrows_text(flow_of(plant, {0}, {}, false)) == "S_T_PUMP -> S_T_TANK_I_LEVEL\n");
  CHECK(flow_of(plant, {1}, {}, false).empty());
}

TEST_CASE("Views with values equal their goldens") {
  const CompiledText plant = tank_with_values();
  check_view_golden(plant, "svg", "values.svg");
  check_view_golden(plant, "dot", "values.dot");
  check_view_golden(plant, "mermaid", "values.mmd");
}

TEST_CASE("symplant lays out the values itself, even if Graphviz is installed") {
  CHECK(render(plant_with_values(R"("values": {"x": {}})"), "svg").decisions ==
        std::vector<std::string>{"the picture is laid out by symplant itself, since it places the values between the "
                                 "inputs and outputs of the plant"});
}

TEST_CASE("No text of a value leaves its element") {
  const CompiledText plant = hostile_values();
  for (const std::string format : {"svg", "html", "mermaid"}) {
    INFO(format);
    const std::string text = render(plant, format).text;
    CHECK_FALSE(contains(text, "<img"));
    CHECK_FALSE(contains(text, "<b>"));
    CHECK_FALSE(contains(text, "\xE2\x80\xAE"));
  }
  CHECK(contains(render(plant, "dot").text, R"(&amp;)"));
  CHECK(contains(render(plant, "dot").text, R"(\"\\N)"));
}

}  // namespace
}  // namespace symplant::test

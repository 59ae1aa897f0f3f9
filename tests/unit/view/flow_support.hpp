// Shared parts of the tests of the signal flow: plants with values.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "description/plant_file.hpp"
#include "view/flow_layout.hpp"
#include "view_support.hpp"

namespace symplant::test {

inline description::Description values_of(const std::string& members) {
  auto reading = description::read_plant_file(R"({"symplant": 1, "symbols": ["a.csv"], )" + members + "}", "s");
  for (const auto& fault : reading.faults) FAIL_CHECK(fault.pointer << ": " << fault.message);
  REQUIRE(reading.file);
  return reading.file->description;
}

/// A pump, a valve, an axis, numbers in both directions.
inline std::vector<Row> flow_rows() {
  std::vector<Row> rows =
      bits({"S_T_PUMP_O_RUN", "S_T_VALVE_O_OPEN", "S_T_AXIS_O_IN", "S_T_AXIS_O_OUT", "S_T_AXIS_I_IN", "S_T_AXIS_I_OUT",
            "S_T_TANK_I_HIGH", "S_T_MIX_O_ON", "S_T_MIX_I_ON", "S_T_RESET_O_ON"});
  rows.push_back({"S_T_TANK_I_LEVEL", "", "INT", "0", "%IW40"});
  rows.push_back({"S_T_TANK_I_TEMP", "", "REAL", "0", "%ID44"});
  rows.push_back({"S_T_TANK_O_SET", "", "INT", "0", "%QW40"});
  return rows;
}

inline CompiledText plant_with_values(const std::string& members, const std::vector<Row>& rows = flow_rows()) {
  CompiledText made = compile_described(rows, values_of(members));
  for (const diag::Diagnostic& finding : made.diagnostics.all()) UNSCOPED_INFO(finding.message);
  REQUIRE(made.compiled);
  return made;
}

/// Each kind of value, source, sink and arrow.
inline CompiledText tank_with_values() {
  return plant_with_values(R"js(
    "material": { "kinds": { "can": { "length": "100 mm", "weight": 2 } },
      "tracks": { "CV": { "length": "1 m", "drives": [ { "speed": { "of": "speed", "unit": "1 m/s" } } ] } },
      "places": { "FIX": {} } },
    "values": {
      "level": { "unit": "l", "start": 20, "min": 0, "max": 100, "integral": "2 * S_T_PUMP.RUN - outflow - leak" },
      "outflow": { "unit": "l/s", "is": "0.3 * sqrt(level) * S_T_VALVE.OPEN" },
      "leak": { "unit": "l/s", "min": 0 },
      "temp": { "unit": "degC", "start": 20, "lag": "20 + 5 * heat - 0.01 * temp * curve(level, 0, 0, 50, 1, 100, 1.5)", "time": "90 s" },
      "heat": { "pid": { "of": "temp", "to": "S_T_TANK_O_SET", "kp": 4, "ti": "60 s" }, "min": 0, "max": 100 },
      "speed": { "ramp": "0.5 * (S_T_MIX.ON or S_T_MIX.moving)", "up": 0.2 },
      "load": { "is": "FIX.weight + FIX.parts + 0.1 * time" },
      "pos": { "unit": "mm", "position": "S_T_AXIS", "at": { "IN": 0, "OUT": 850 } },
      "cycles": { "changes": [ { "when": "S_T_RESET_O_ON", "to": "0" }, { "when": "pos > 800", "to": "cycles + 1" },
                               { "when": "load > 5", "to": "cycles + 2" } ] } },
    "signals": { "S_T_TANK_I_LEVEL": { "of": "level", "from": [0, 100], "to": [0, 27648] },
                 "S_T_TANK_I_TEMP": "temp + 0 * S_T_PUMP.RUN" },
    "follow": { "S_T_TANK_I_HIGH": "level > 90 and S_T_VALVE.OPEN" },
    "devices": { "S_T_MIX": { "transitions": [ { "from": "*", "to": "ON", "when": "level > 10" } ] } },
    "requirements": [ { "name": "not dry", "never": "level <= 5" } ])js");
}

/// A unit, a symbol and a formula whose texts would end an element, a string or a line.
inline CompiledText hostile_values() {
  std::vector<Row> rows = flow_rows();
  rows.push_back({"</text><b>\"\\N", "", "INT", "0", "%IW60"});
  description::Description given = values_of(R"("values": {"x": {"unit": "u"}})");
  given.values[0].unit = kHarm;
  given.values[0].changes = {{"'</text><b>\"\\N' > 3", "'</text><b>\"\\N' + 1"}};
  CompiledText made = compile_described(rows, std::move(given));
  REQUIRE(made.compiled);
  return made;
}

/// The flow of all devices and locations, or of the given ones.
inline view::Flow flow_of(const CompiledText& compiled, std::vector<std::uint32_t> units = {},
                          std::vector<std::uint32_t> locations = {}, bool all = true) {
  if (all) {
    for (std::uint32_t u = 0; u < compiled.plant().units.size(); ++u) units.push_back(u);
    for (std::uint32_t l = 0; l < compiled.plant().material.locations(); ++l) locations.push_back(l);
  }
  return view::flow_of({compiled.plant(), compiled.tables(), std::move(units), std::move(locations)});
}

/// `a -> b`, `a ..> b` for one in a condition; one per line.
inline std::string arrows_text(const view::Flow& flow) {
  std::string text;
  for (const view::FlowArrow& arrow : flow.arrows) {
    text += flow.boxes[arrow.from].lines[0] + (arrow.in_condition ? " ..> " : " -> ") + flow.boxes[arrow.to].lines[0] +
            "\n";
  }
  return text;
}

inline std::string boxes_text(const view::Flow& flow) {
  std::string text;
  for (const view::FlowBox& box : flow.boxes) {
    text += std::string(view::flow_class(box.kind)).substr(5);
    for (const std::string& line : box.lines) text += " | " + line;
    text += "\n";
  }
  return text;
}

}  // namespace symplant::test

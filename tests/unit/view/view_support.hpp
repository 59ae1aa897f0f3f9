// Shared parts of the tests of views: a plant with every feature of descriptions, and one with hostile names.
#pragma once

#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/compile.hpp"
#include "support/golden.hpp"
#include "support/strings.hpp"
#include "view/chart.hpp"
#include "view/formats.hpp"

namespace symplant::test {

inline description::GivenTransition transition(std::string from, std::string to) {
  description::GivenTransition given;
  given.from = std::move(from);
  given.to = std::move(to);
  return given;
}

/// A cell: a vehicle that docks, a machine that it feeds, a stopper with a behavior, a door, a table of six positions;
/// every feature of descriptions is in it.
inline CompiledText described_cell() {
  using description::Duration;
  std::vector<Row> rows{{"L_P_AGV_O_P1", "Y1", "BOOL", "FALSE", "%QX1"},
                        {"L_P_AGV_O_P2", "Y2"},
                        {"L_P_AGV_O_CHARGE", "Y3"},
                        {"L_P_AGV_I_P1", "X1"},
                        {"L_P_AGV_I_P2", "X2"},
                        {"L_P_AGV_I_BUSY", "X3"},
                        {"L_P_MC_O_IDLE1", "Y4"},
                        {"L_P_MC_O_RUN2", "Y5"},
                        {"L_P_MC_I_IDLE1", "X4"},
                        {"L_P_MC_I_RUN2", "X5"},
                        {"L_Q_STOPPER1_O_ADV", "Y6"},
                        {"L_Q_STOPPER1_I_ADV", "X6"},
                        {"L_Q_STOPPER1_I_RET", "X7"},
                        {"L_Q_STOPPER1_I_WEIGHT", "", "INT", "-5", "%IW9"},
                        {"L_Q_DOOR_I_OPEN1", "X8", "BOOL", "TRUE"},
                        {"L_Q_DOOR_I_CLOSED2", "X9"},
                        {"LEVEL", "", "REAL", "1.5", "%ID20"},
                        {"BIG", "", "ULINT", "18446744073709551615", "%IL30"},
                        {"START", "X11"}};
  for (const char* index : {"A1", "B2", "C3", "D4", "E5", "F6"}) {
    rows.push_back({std::string("M_T_TABLE_O_") + index});
    rows.push_back({std::string("M_T_TABLE_I_") + index});
  }

  description::DeviceDescription agv;
  agv.path = "L_P_AGV";
  agv.states = {"DOCK"};
  agv.initial = "P1";
  agv.transitions = {transition("P1", "P2"), transition("*", "P1"), transition("P2", "DOCK"), transition("P1", "P2")};
  agv.transitions[0].takes = Duration::fixed(2 * tables::kSecond);
  agv.transitions[1].takes = {Duration::Kind::uniform, 1'800 * tables::kMillisecond, 2'200 * tables::kMillisecond};
  agv.transitions[2].on = "CHARGE";
  agv.transitions[2].takes = {Duration::Kind::normal, 4 * tables::kSecond, 100 * tables::kMillisecond};
  agv.transitions[2].once = true;
  agv.transitions[3].on = "CHARGE";
  agv.transitions[3].when = "not (L_P_MC.RUN2 or L_Q_DOOR.OPEN1) and LEVEL < 2.5";
  agv.outputs = {{"DOCK", {{"BUSY", true}}, {{"BUSY", false}}}};

  description::DeviceDescription machine;
  machine.path = "L_P_MC";
  machine.only = true;
  machine.transitions = {transition("IDLE1", "RUN2"), transition("RUN2", "IDLE1")};
  machine.transitions[0].when = "L_P_AGV.P2";
  machine.transitions[1].automatic = true;
  machine.transitions[1].after = Duration::fixed(5 * tables::kSecond);
  machine.disables = {{"RUN2", {"L_P_AGV", "L_Q_DOOR"}}};

  description::DeviceDescription stopper;
  stopper.path = "L_Q_STOPPER1";
  stopper.type = "Stopper";
  stopper.behaviour = "MyStopper";
  stopper.inputs = {{"part", "L_P_AGV.P2 and not L_P_AGV.moving"}};
  stopper.transitions = {transition("ADV", "RET")};
  stopper.transitions[0].takes = Duration::fixed(800 * tables::kMillisecond);

  description::Description description;
  description.devices = {agv, machine, stopper};
  description.requirements = {{"no machining without part", "L_P_MC.RUN2 and not L_P_AGV.P2", "", "", 0},
                              {"machine starts", "", "L_P_AGV.P2", "L_P_MC_O_RUN2", 500 * tables::kMillisecond}};
  CompiledText compiled = compile_described(rows, std::move(description));
  REQUIRE(compiled.compiled);
  return compiled;
}

/// A clamp that waits for a part in the place P, whose sensor is L_P_PE_I_PART; a requirement about the parts there.
inline CompiledText cell_with_parts() {
  description::Description description;
  description.material.kinds = {{"raw", 1000, 0}};
  description.material.places = {{"P", "", 2, {}}};
  description.material.places[0].sensors.emplace_back().symbol = "L_P_PE_I_PART";
  description::DeviceDescription clamp;
  clamp.path = "L_P_CL";
  clamp.transitions = {transition("RET", "ADV")};
  clamp.transitions[0].when = "P.part and not P.parts > 1 or P.raw";
  description.devices.push_back(std::move(clamp));
  description.requirements.emplace_back().name = "never empty";
  description.requirements[0].never = "P.parts = 0 or P.parts < 0";
  return compile_described(bits({"L_P_PE_I_PART", "L_P_CL_O_ADV", "L_P_CL_I_ADV", "L_P_CL_O_RET", "L_P_CL_I_RET"}),
                           std::move(description));
}

/// A track and a place with every element of a material flow.
inline CompiledText plant_with_material() {
  description::Description given;
  given.material.kinds = {{"raw", 200'000, 1}, {"done", 200'000, 0}};
  description::GivenTrack track;
  track.name = "CV1";
  track.length = 2'000'000;
  track.gap = 10'000;
  track.drives = {{1'000'000, "L_P_CV.RUN", "", {400'000, ""}}, {{}, "", "L_P_CV.RUN", {10'000, "L_P_CV_O_SPEED"}}};
  track.stops = {{500'000, "L_P_CV.RUN"}};
  track.sensors = {{"L_P_PE_I_ON", 300'000, {"raw"}, true, tables::SensorReads::part}};
  track.ends = {{"FIX", "L_P_CV.RUN"}, {"out", ""}};
  given.material.tracks = {track};
  given.material.places = {{"FIX", "", 2, {{"L_P_NR_I_CODE", {}, {}, false, tables::SensorReads::number}}}};
  given.material.transfers = {{"pick", "", "CV1@1 m", "out", "L_P_CV.RUN", true}};
  given.material.work = {{"mill", "", "FIX", "L_P_CV.RUN", "raw", "done"}};
  given.material.sources = {
      {"feed", "", "CV1", {"raw"}, description::Duration::fixed(tables::kSecond), tables::kSecond, "", 3}};
  CompiledText made = compile_described({{"L_P_CV_O_RUN", "Y1"},
                                         {"L_P_CV_I_RUN", "X1"},
                                         {"L_P_PE_I_ON", "X2"},
                                         {"L_P_CV_O_SPEED", "", "INT"},
                                         {"L_P_NR_I_CODE", "", "INT"}},
                                        given);
  REQUIRE(made.compiled);
  return made;
}

/// Names that would end a string, an element, a comment or a line, everywhere a name can be.
inline const std::string kHarm = "</script><img src=x onerror=\"a('&')\">]]>--\\N;\xE2\x80\xAE%%\n";

inline CompiledText hostile_cell() {
  description::DeviceDescription device;
  device.path = "L_P_D";
  device.states = {kHarm};
  device.type = "Harm";
  device.behaviour = "OwnHarm";
  device.inputs = {{kHarm, "L_P_D.A1"}};
  device.transitions = {transition("A1", kHarm), transition(kHarm, "A1")};
  device.transitions[0].automatic = true;
  device.transitions[0].when = "'</script><b>'";
  description::Description description;
  description.devices = {device};
  description.requirements = {{kHarm, "L_P_D.moving", "", "", 0}};
  CompiledText compiled =
      compile_described({{"L_P_D_O_A1", "Y1"}, {"L_P_D_I_A1", "X1"}, {"</script><b>", "X2"}}, std::move(description));
  for (const diag::Diagnostic& finding : compiled.diagnostics.all()) UNSCOPED_INFO(finding.message);
  REQUIRE(compiled.compiled);
  return compiled;
}

struct Rendered {
  std::string text;
  std::vector<std::string> decisions;
};

inline Rendered render(const CompiledText& compiled, std::string_view format, std::vector<std::uint32_t> units,
                       base::ProcessRunner* programs = nullptr) {
  std::vector<std::uint32_t> locations;
  if (units.size() == compiled.plant().units.size()) {
    const model::Material& material = compiled.plant().material;
    locations.resize(material.locations());
    std::iota(locations.begin(), locations.end(), 0);
  }
  view::View view = view::find_format(format)->render(
      {compiled.plant(), compiled.tables(), std::move(units), std::move(locations), programs});
  return {base::text_of(view.text), std::move(view.decisions)};
}

/// All units.
inline Rendered render(const CompiledText& compiled, std::string_view format, base::ProcessRunner* programs = nullptr) {
  std::vector<std::uint32_t> units;
  for (std::uint32_t u = 0; u < compiled.plant().units.size(); ++u) units.push_back(u);
  return render(compiled, format, std::move(units), programs);
}

inline void check_view_golden(const CompiledText& compiled, std::string_view format, const std::string& file) {
  check_golden(std::string(SYMPLANT_SOURCE_DIR) + "/tests/golden/view/" + file, render(compiled, format).text);
}

}  // namespace symplant::test

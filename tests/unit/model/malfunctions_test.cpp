// The malfunctions of a plant: which devices and symbols they name, and what is wrong with them.
#include "material_support.hpp"
#include "support/strings.hpp"

namespace symplant::test {
namespace {

/// Two clamps, a door, a sensor, a number, and two inputs on one address.
Analysed station(const std::string& malfunctions) {
  std::vector<Row> rows = bits({"S_10_CL1_O_OPEN", "S_10_CL1_O_SHUT", "S_10_CL1_I_OPEN", "S_10_CL1_I_SHUT",
                                "S_10_CL2_O_OPEN", "S_10_CL2_O_SHUT", "S_10_CL2_I_OPEN", "S_10_CL2_I_SHUT",
                                "S_10_DOOR_I_OPEN", "S_10_DOOR_I_FAST", "S_10_PE1_I_PART"});
  rows.push_back({"LEVEL", "", "INT", "0", "%IW40"});
  rows.push_back({"LEFT", "", "BOOL", "FALSE", "%IX101"});
  rows.push_back({"RIGHT", "", "BOOL", "FALSE", "%IX101"});
  return analyse_described(rows, read_description("\"malfunctions\": [" + malfunctions + "]"));
}

std::string faults_of(const std::string& malfunctions) { return faults(station(malfunctions)); }
std::string warnings_of(const std::string& malfunctions) { return material_warnings(station(malfunctions)); }

/// The units of the first malfunction, each with its state: "S_10_CL1:OPEN S_10_CL2".
std::string units_text(const std::string& malfunctions) {
  const Analysed plant = station(malfunctions);
  CHECK(faults(plant) == "");
  std::string text;
  for (const tables::MalfunctionUnit& each : plant.model().malfunctions.at(0).effects.at(0).units) {
    const model::Unit& unit = plant.model().units[each.unit];
    text += (text.empty() ? "" : " ") + std::string(unit.path);
    if (each.state != tables::kNoState) text += ":" + unit.states[each.state].name;
  }
  return text;
}

TEST_CASE("A malfunction names devices and patterns, each device is in it once") {
  CHECK(units_text(R"({"name": "m", "of": "s_10_cl1", "slower": 2})") == "S_10_CL1");
  CHECK(units_text(R"({"name": "m", "of": "S_10_CL?", "stuck": true})") == "S_10_CL1 S_10_CL2");
  CHECK(units_text(R"({"name": "m", "of": ["S_10_CL2", "S_10_CL*", "S_10_CL1"], "stuck": true})") ==
        "S_10_CL1 S_10_CL2");
  CHECK(units_text(R"({"name": "m", "of": "S_10_CL*", "stuck": "open"})") == "S_10_CL1:OPEN S_10_CL2:OPEN");
}

TEST_CASE("A device that does not exist is an error, a pattern that matches none a warning") {
  CHECK(faults_of(R"({"name": "m", "of": "S_10_CL3", "stuck": true})") ==
        "/malfunctions/0/of: device `S_10_CL3` not found; did you mean `S_10_CL1`?");
  CHECK(faults_of(R"({"name": "m", "of": "X*", "stuck": true})") == "");
  CHECK(warnings_of(R"({"name": "m", "of": ["X*"], "stuck": true})") ==
        "/malfunctions/0/of/0: `X*` matches no device and no track");
}

TEST_CASE("A state that a named device lacks is an error, devices of a pattern that lack it are left out") {
  CHECK(faults_of(R"({"name": "m", "of": "S_10_CL1", "stuck": "OPNE"})") ==
        "/malfunctions/0/stuck: state `OPNE` of `S_10_CL1` not found; did you mean `OPEN`?");
  CHECK(contains(faults_of(R"({"name": "m", "of": "*", "stuck": "HALF"})"), "/malfunctions/0/stuck: state `HALF`"));
  const std::string some = R"({"name": "m", "of": "*", "stuck": "SHUT"})";
  CHECK(units_text(some) == "S_10_CL1:SHUT S_10_CL2:SHUT");
  CHECK(
      warnings_of(some) ==
      "/malfunctions/0/stuck: 2 of the 4 devices that `*` names have no state `SHUT`; the malfunction leaves them out, "
      "the first is `S_10_DOOR`");
}

TEST_CASE("Only slower and stuck name devices, and they must") {
  CHECK(faults_of(R"({"name": "m", "of": "S_10_CL1", "force": {"LEFT": true}})") ==
        "/malfunctions/0/of: `of` is only for `slower` and `stuck`; remove it");
  CHECK(faults_of(R"({"name": "m", "stuck": true})") == "/malfunctions/0: this malfunction names no device; add `of`");
}

TEST_CASE("Names are unique, and none is that of an ordinary malfunction") {
  const auto named = [](const std::string& name) {
    return faults_of(R"({"name": "jam", "of": "S_10_CL1", "stuck": true}, {"name": ")" + name + R"(", "lose": true})");
  };
  CHECK(named("jam 2") == "");
  CHECK(named("JAM") == "/malfunctions/1/name: `JAM` already names another malfunction; choose another name");
  const auto ordinary = [](const std::string& name) {
    return "/malfunctions/1/name: `" + name +
           "` is an ordinary malfunction, which every plant has; choose another name";
  };
  for (const std::string name : {"S_10_CL1 stuck", "s_10_cl1 SLOW", "S_10_PE1_I_PART stuck on", "LEFT stuck off"}) {
    CHECK(named(name) == ordinary(name));
  }
  CHECK(named("S_10_CL9 stuck") == "");
  CHECK(named("S_10_CL1_O_OPEN stuck on") == "");
  CHECK(named("LEVEL stuck on") == "");
}

TEST_CASE("A forced value fits its symbol") {
  const auto forced = [](const std::string& values) {
    return faults_of(R"({"name": "m", "force": {)" + values + "}}");
  };
  CHECK(forced(R"("S_10_CL1_O_OPEN": true, "LEVEL": -7)") == "");
  CHECK(forced(R"("LEVELS": 1)") == "/malfunctions/0/force/LEVELS: symbol `LEVELS` not found; did you mean `LEVEL`?");
  CHECK(forced(R"("LEFT": 1)") == "/malfunctions/0/force/LEFT: expected true or false for a BOOL, but found `1`");
  CHECK(forced(R"("LEVEL": true)") == "/malfunctions/0/force/LEVEL: expected a number for a INT, but found `true`");
  CHECK(contains(forced(R"("LEVEL": 40000)"), "/malfunctions/0/force/LEVEL: "));
  CHECK(forced(R"("LEFT": true, "RIGHT": true)") ==
        "/malfunctions/0/force/RIGHT: `RIGHT` and `LEFT` are on one address; name one of them");
  CHECK(forced("") == "/malfunctions/0/force: this malfunction gives no symbol a value; name at least one");
}

TEST_CASE("Only BOOL symbols flicker") {
  const auto flicker = [](const std::string& symbol) {
    return faults_of(R"({"name": "m", "flicker": {"symbol": ")" + symbol + R"(", "every": "1s", "for": "1s"}})");
  };
  CHECK(flicker("S_10_CL1_O_OPEN") == "");
  CHECK(flicker("LEVEL") == "/malfunctions/0/flicker/symbol: `LEVEL` is a number; only BOOL symbols flicker");
  CHECK(flicker("LEFTT") == "/malfunctions/0/flicker/symbol: symbol `LEFTT` not found; did you mean `LEFT`?");
}

TEST_CASE("A lost link is that of a controller of the plant") {
  CHECK(faults_of(R"({"name": "m", "lose": true})") == "");
  CHECK(contains(faults_of(R"({"name": "m", "lose": "PLC1"})"), "/malfunctions/0/lose: controller `PLC1` not found"));
}

TEST_CASE("Conditions and the malfunction that another one becomes are found") {
  const std::string second = R"(, {"name": "stuck", "of": "S_10_CL1", "stuck": true})";
  const auto with = [&](const std::string& members) {
    return faults_of(R"({"name": "slow", "of": "S_10_CL1", "slower": 2, )" + members + "}" + second);
  };
  CHECK(with(R"("when": "S_10_CL1.OPEN", "becomes": {"after": "1s", "unless": "LEFT", "start": "STUCK"})") == "");
  CHECK(with(R"("when": "S_10_CL1.OPNE")") ==
        "/malfunctions/0/when: state `OPNE` of `S_10_CL1` not found; did you mean `OPEN`?");
  CHECK(contains(with(R"("becomes": {"after": "1s", "unless": "NONE or", "start": "stuck"})"),
                 "/malfunctions/0/becomes/unless: "));
  CHECK(with(R"("becomes": {"after": "1s", "start": "stuk"})") ==
        "/malfunctions/0/becomes/start: malfunction `stuk` not found; did you mean `stuck`?");
  CHECK(with(R"("becomes": {"after": "1s", "start": "slow"})") == "");
}

/// A track, a parameter, an integral, and a signal.
Analysed line(const std::string& malfunctions) {
  std::vector<Row> rows = bits(
      {"S_10_CV_O_RUN", "S_10_CL1_O_OPEN", "S_10_CL1_O_SHUT", "S_10_CL1_I_OPEN", "S_10_CL1_I_SHUT", "S_10_PE1_I_PART"});
  rows.push_back({"TEMP", "", "INT", "0", "%IW40"});
  rows.push_back({"SPEED", "", "INT", "0", "%QW40"});
  return analyse_described(rows, read_description(R"("material": {"kinds": {"box": {"length": "100mm"}}, "tracks": {
    "A": {"length": "1m", "drives": [{"forward": "S_10_CV_O_RUN", "speed": "1m/s"}]},
    "B": {"length": "1m", "drives": [{"forward": "S_10_CV_O_RUN", "speed": "1m/s"}]}}},
    "values": {"wind": {}, "x": {"integral": "wind"}}, "signals": {"TEMP": "x"}, "malfunctions": [)" +
                                                  malfunctions + "]"));
}

std::string faults_in_line(const std::string& malfunctions) { return faults(line(malfunctions)); }

TEST_CASE("A malfunction acts on tracks, by name and by pattern") {
  const Analysed plant = line(R"({"name": "m", "of": ["b", "S_10_CL1", "?"], "slower": 2})");
  CHECK(faults(plant) == "");
  const model::Effect& effect = plant.model().malfunctions.at(0).effects.at(0);
  CHECK(effect.tracks == std::vector<std::uint32_t>{0, 1});
  REQUIRE(effect.units.size() == 1);
  CHECK(faults_in_line(R"({"name": "m", "of": "C", "stuck": true})") ==
        "/malfunctions/0/of: device or track `C` not found; did you mean `A`?");
  CHECK(faults_in_line(R"({"name": "m", "of": "A", "stuck": "OPEN"})") ==
        "/malfunctions/0/stuck: `A` is a track, which has no states; write `true`");
  CHECK(faults_in_line(R"({"name": "m", "of": ["?", "S_10_CL1"], "stuck": "OPEN"})") == "");
}

TEST_CASE("A malfunction holds events, not operations") {
  CHECK(faults_in_line(R"({"name": "m", "force": {"TEMP": "hold", "S_10_CL1_I_OPEN": "hold"}})") == "");
  CHECK(
      faults_in_line(R"({"name": "m", "force": {"SPEED": "hold"}})") ==
      "/malfunctions/0/force/SPEED: `SPEED` is an operation; only events hold what they show, so write the value that "
      "it has");
}

TEST_CASE("A malfunction sets parameters only") {
  const Analysed plant = line(R"({"name": "m", "set": {"WIND": 3}})");
  CHECK(faults(plant) == "");
  CHECK(plant.model().malfunctions.at(0).effects.at(0).sets.at(0).number == 3);
  CHECK(faults_in_line(R"({"name": "m", "set": {"x": 3}})") ==
        "/malfunctions/0/set/x: `x` is computed; a malfunction sets only parameters, which have no formula");
  CHECK(faults_in_line(R"({"name": "m", "set": {"wint": 3}})") ==
        "/malfunctions/0/set/wint: parameter `wint` not found; did you mean `wind`?");
  CHECK(faults_in_line(R"({"name": "m", "set": {"wind": 3, "WIND": 4}})") ==
        "/malfunctions/0/set/wind: `wind` and `WIND` are one parameter; remove one");
}

TEST_CASE("Only signals are out of adjustment") {
  CHECK(faults_in_line(R"({"name": "m", "distort": {"symbol": "temp", "gain": 2}})") == "");
  CHECK(faults_in_line(R"({"name": "m", "distort": {"symbol": "SPEED", "gain": 2}})") ==
        "/malfunctions/0/distort/symbol: `SPEED` has no entry in `signals`; only signals can be out of adjustment");
}

TEST_CASE("Effects that name no devices use those of the malfunction") {
  const Analysed plant =
      line(R"({"name": "m", "of": "A", "effects": [{"stuck": true}, {"of": "S_10_CL1", "slower": 3}]})");
  CHECK(faults(plant) == "");
  const auto& effects = plant.model().malfunctions.at(0).effects;
  CHECK(effects.at(0).tracks.size() == 1);
  CHECK(effects.at(1).tracks.empty());
  CHECK(effects.at(1).units.size() == 1);
  CHECK(faults_in_line(R"({"name": "m", "of": "A", "effects": [{"set": {"wind": 1}}]})") ==
        "/malfunctions/0/of: no effect of this malfunction needs `of`; remove it");
  CHECK(faults_in_line(R"({"name": "m", "effects": [{"set": {"wind": 1}}, {"stuck": true}]})") ==
        "/malfunctions/0/effects/1: this malfunction names no device; add `of`");
  CHECK(faults_in_line(R"({"name": "m", "effects": [{"of": "A", "set": {"wind": 1}}]})") ==
        "/malfunctions/0/effects/0/of: `of` is only for `slower` and `stuck`; remove it");
}

TEST_CASE("The condition of `while` is resolved where it is written") {
  CHECK(faults_in_line(R"({"name": "m", "while": "wind > 3", "set": {"wind": 1}})") == "");
  CHECK(contains(faults_in_line(R"({"name": "m", "while": "S_10_CL1.OPNE", "of": "A", "stuck": true})"),
                 "/malfunctions/0/while: state `OPNE` of `S_10_CL1` not found"));
}

}  // namespace
}  // namespace symplant::test

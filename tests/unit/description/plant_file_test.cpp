// plant.json: what is read from it, and what is rejected.
#include "description/plant_file.hpp"

#include <nlohmann/json.hpp>

#include "description/plant_schema.hpp"
#include "symplant/json/schema.hpp"
#include "unit/model/model_support.hpp"

namespace symplant::test {
namespace {

using description::Duration;
using description::PlantFileReading;

PlantFileReading read(const std::string& members) {
  return description::read_plant_file(
      "{\"symplant\": 1, \"symbols\": [\"a.csv\"]" + (members.empty() ? "" : ", " + members) + "}", "stem");
}

/// All faults: "pointer: message", one per line.
std::string shape(const PlantFileReading& reading) {
  std::string text;
  for (const json::Placed& fault : reading.syntax) text += "syntax: " + fault.message + "\n";
  for (const description::DescriptionFault& fault : reading.faults) text += fault.pointer + ": " + fault.message + "\n";
  if (!text.empty()) text.pop_back();
  return text;
}

std::string shape(const std::string& members) { return shape(read(members)); }

/// The faults of a whole text.
std::string refused(const std::string& text) {
  const PlantFileReading reading = description::read_plant_file(text, "stem");
  CHECK_FALSE(reading.file);
  return shape(reading);
}

description::PlantFile sound(const std::string& members) {
  PlantFileReading reading = read(members);
  INFO(members);
  CHECK(shape(reading) == "");
  REQUIRE(reading.file);
  return std::move(*reading.file);
}

description::DeviceDescription device_of(const std::string& members) {
  const description::PlantFile file = sound("\"devices\": {\"L_P_D\": {" + members + "}}");
  REQUIRE(file.description.devices.size() == 1);
  return file.description.devices.front();
}

std::optional<Duration> takes(const std::string& value) {
  return device_of(R"("transitions": [{"from": "A", "to": "B", "takes": )" + value + "}]").transitions.front().takes;
}

std::string takes_fault(const std::string& value) {
  const std::string where = "/devices/D/transitions/0/takes";
  std::string fault = shape(R"("devices": {"D": {"transitions": [{"from": "A", "to": "B", "takes": )" + value + "}]}}");
  REQUIRE(fault.starts_with(where));
  return fault.substr(where.size());
}

TEST_CASE("Two keys make a plant: version and lists, its name is that of the file") {
  const description::PlantFile file = sound("");
  CHECK(file.name == "stem");
  REQUIRE(file.symbols.size() == 1);
  CHECK(file.symbols[0].file == "a.csv");
  CHECK(file.symbols[0].format == "");
  CHECK_FALSE(file.symbols[0].encoding);
  CHECK(file.description.devices.empty());
  CHECK(file.description.defaults.travel == tables::kSecond);
  CHECK(file.description.defaults.dwell == tables::kSecond);
  CHECK(file.description.defaults.actuation == tables::Actuation::latched);
  CHECK(sound(R"("name": "cell", "$schema": "./plant.schema.json")").name == "cell");
}

TEST_CASE("A list may be an object with read options") {
  const PlantFileReading reading = description::read_plant_file(
      R"({"symplant": 1, "symbols": ["a.csv", {"file": "b.csv", "format": "gx-iec", "encoding": "utf-16le",
          "controller": "PLC1", "xy": "octal"}], "links": [{"url": "loop:", "controller": "plc1"}, {"url": "loop:"}]})",
      "s");
  CHECK(shape(reading) == "");
  REQUIRE(reading.file);
  const description::ListReference& list = reading.file->symbols.at(1);
  CHECK(list.file == "b.csv");
  CHECK(list.format == "gx-iec");
  CHECK(list.encoding == text::Encoding::utf16le);
  CHECK(list.controller == "PLC1");
  CHECK(list.xy == address::Radix::octal);
  REQUIRE(reading.file->description.links.size() == 2);
  CHECK(reading.file->description.links[0].url == "loop:");
  CHECK(reading.file->description.links[0].controller == "plc1");
  CHECK(reading.file->description.links[1].controller == "");
}

TEST_CASE("Defaults are read") {
  const description::Defaults defaults =
      sound(R"("defaults": {"travel": "2 s", "dwell": "1.5min", "actuation": "held"})").description.defaults;
  CHECK(defaults.travel == 2 * tables::kSecond);
  CHECK(defaults.dwell == 90 * tables::kSecond);
  CHECK(defaults.actuation == tables::Actuation::held);
}

TEST_CASE("A device's keys are read") {
  const description::DeviceDescription d = device_of(R"(
    "states": ["DOCK"], "initial": "P1", "rest": "P2", "actuation": "spring", "only": true,
    "transitions": [{"from": "*", "to": "DOCK", "on": "CHARGE", "when": "L_P_E.P1", "once": true, "after": "1ms"},
                    {"from": "P1", "to": "P2", "automatic": true}],
    "outputs": {"RUN2": {"enter": {"BUSY": true, "A": false}, "leave": {"BUSY": false}}},
    "disables": {"RUN2": ["L_P_E", "*_X"]}, "type": "Stopper", "behaviour": "MyStopper",
    "inputs": {"part": "L_P_E.P1"})");
  CHECK(d.path == "L_P_D");
  CHECK(d.states == std::vector<std::string>{"DOCK"});
  CHECK(d.initial == "P1");
  CHECK(d.rest == "P2");
  CHECK(d.actuation == tables::Actuation::spring);
  CHECK(d.only);
  REQUIRE(d.transitions.size() == 2);
  CHECK(d.transitions[0].from == "*");
  CHECK(d.transitions[0].to == "DOCK");
  CHECK(d.transitions[0].on == "CHARGE");
  CHECK(d.transitions[0].when == "L_P_E.P1");
  CHECK(d.transitions[0].once);
  CHECK(d.transitions[0].after == Duration::fixed(tables::kMillisecond));
  CHECK_FALSE(d.transitions[0].takes);
  CHECK_FALSE(d.transitions[0].automatic);
  CHECK(d.transitions[1].automatic);
  REQUIRE(d.outputs.size() == 1);
  CHECK(d.outputs[0].state == "RUN2");
  CHECK(d.outputs[0].enter == std::vector<std::pair<std::string, bool>>{{"A", false}, {"BUSY", true}});
  CHECK(d.outputs[0].leave == std::vector<std::pair<std::string, bool>>{{"BUSY", false}});
  REQUIRE(d.disables.size() == 1);
  CHECK(d.disables[0].state == "RUN2");
  CHECK(d.disables[0].devices == std::vector<std::string>{"L_P_E", "*_X"});
  CHECK(d.type == "Stopper");
  CHECK(d.behaviour == "MyStopper");
  CHECK(d.inputs == std::vector<std::pair<std::string, std::string>>{{"part", "L_P_E.P1"}});
}

TEST_CASE("Requirements and the settings of check are read") {
  const description::Description description = sound(R"(
    "requirements": [{"name": "n", "never": "A"}, {"name": "w", "after": "A", "expect": "B", "within": "500ms"},
                     {"name": "m", "after": "A", "expect": "B", "within": {"min": "1s", "max": "2s"}}],
    "check": {"ignore": [{"rule": "SP402", "symbols": "*_SPARE*", "why": "spare", "until": "2027-06-30"},
                         {"rule": "no-address", "why": "later"}],
              "severity": {"event-not-driven": "error"}})")
                                                   .description;
  REQUIRE(description.requirements.size() == 3);
  CHECK(description.requirements[0].never == "A");
  CHECK(description.requirements[1].after == "A");
  CHECK(description.requirements[1].expect == "B");
  CHECK(description.requirements[1].within == 500 * tables::kMillisecond);
  CHECK(description.requirements[1].earliest == 0);
  CHECK(description.requirements[2].earliest == tables::kSecond);
  CHECK(description.requirements[2].within == 2 * tables::kSecond);
  REQUIRE(description.check.ignore.size() == 2);
  CHECK(description.check.ignore[0].symbols == "*_SPARE*");
  CHECK(description.check.ignore[0].until == "2027-06-30");
  CHECK(description.check.ignore[1].symbols == "");
  CHECK(description.check.severity == std::vector<std::pair<std::string, std::string>>{{"event-not-driven", "error"}});
}

TEST_CASE("`view` places a device, or names its frame") {
  const auto file = sound(R"("view": {"L1_A_D1": {"x": 3, "y": 1}, "L1_A_D2": {"group": "Safety"}})");
  REQUIRE(file.description.view.size() == 2);
  const description::GivenView& placed = file.description.view[0];
  CHECK(placed.device == "L1_A_D1");
  CHECK(placed.x == 3);
  CHECK(placed.y == 1);
  CHECK(placed.group == "");
  const description::GivenView& grouped = file.description.view[1];
  CHECK(grouped.x == -1);
  CHECK(grouped.y == -1);
  CHECK(grouped.group == "Safety");
}

TEST_CASE("A place in `view` without `y`, below 0 or too far is rejected") {
  const std::string half = "/view/D: a place has `x` and `y`; add the other one";
  CHECK(shape(R"("view": {"D": {"x": 3}})") == half);
  CHECK(shape(R"("view": {"D": {"y": 3}})") == half);
  const std::string expected = ": expected a whole number from 0 to 1000, but found the number ";
  CHECK(shape(R"("view": {"D": {"x": -1, "y": 0}})") == "/view/D/x" + expected + "`-1`");
  CHECK(shape(R"("view": {"D": {"x": 0, "y": 1001}})") == "/view/D/y" + expected + "`1001`");
  CHECK_THAT(shape(R"("view": {"D": {"x": 0.5, "y": 0}})"),
             Catch::Matchers::StartsWith("/view/D/x" + expected + "`0.5`"));
  CHECK(shape(R"("view": {"D": 3})") ==
        "/view/D: expected an object with `x` and `y`, `group`, or `shape`, but found the number `3`");
}

TEST_CASE("A frame in `view` has a name that can be shown") {
  CHECK(shape(R"("view": {"D": {"group": ""}})") ==
        "/view/D/group: expected the name of a frame, but found an empty text");
  CHECK_THAT(shape(R"("view": {"D": {"group": "two\nlines"}})"),
             Catch::Matchers::ContainsSubstring("control character"));
  CHECK(shape(R"("view": {"D": {"grp": "Safety"}})") ==
        "/view/D/grp: the key `grp` is unknown here; the known keys are `group`, `shape`, `x`, `y`");
}

TEST_CASE("`view` gives the shape of a device in the plan") {
  const auto file = sound(R"("view": {"L1_A_D1": {"shape": "gripper"}, "L1_A_D2": {"x": 1, "y": 2}})");
  CHECK(file.description.view[0].shape == tables::Shape::gripper);
  CHECK_FALSE(file.description.view[1].shape);
  CHECK_THAT(shape(R"("view": {"D": {"shape": "griper"}})"),
             Catch::Matchers::StartsWith("/view/D/shape: expected one of `button`, `clamp`"));
}

TEST_CASE("`plan` and `view3d` are kept as they are, with the names in them") {
  const auto file = sound(R"("plan": {"frames": {"L1 A": {"x": 0, "y": 0}}, "devices": {"D": {"group": "Safety"}},
    "locations": {"CV1": {"x": 1.5, "y": -2, "turn": 90, "length": 8}}}, "view3d": {"model": "cell.glb",
    "nodes": {"D": {"node": "Cell/D", "P2": {"move": [2.4, 0, 0]}}, "free": {"node": "X", "turn": {"by": "T.a", "axis": "y"}},
    "CV1": {"node": "CV", "from": [0, 0, 0], "to": [3, 0, 0]}}})");
  const description::GivenScene& scene = file.description.scene;
  CHECK(
      scene.plan ==
      R"({"devices":{"D":{"group":"Safety"}},"frames":{"L1 A":{"x":0,"y":0}},"locations":{"CV1":{"length":8,"turn":90,"x":1.5,"y":-2}}})");
  CHECK_THAT(scene.view3d, Catch::Matchers::StartsWith(R"({"model":"cell.glb","nodes":)"));
  CHECK(scene.groups == std::vector<std::string>{"Safety"});
  std::string names;
  for (const description::SceneName& name : scene.names) {
    names += name.pointer + ": " + name.name + (name.state.empty() ? "" : " in " + name.state) + "\n";
  }
  CHECK(names ==
        "/plan/devices/D: D\n/plan/locations/CV1: CV1\n/plan/frames/L1 A: L1 A\n/view3d/nodes/CV1: CV1\n"
        "/view3d/nodes/D/P2: D in P2\n/view3d/nodes/free/turn/by: T.a\n");
}

TEST_CASE("A position in `plan` that is too far, an unknown turn, and a node without a path are rejected") {
  CHECK_THAT(shape(R"("plan": {"frames": {"S": {"x": 10001, "y": 0}}})"),
             Catch::Matchers::StartsWith("/plan/frames/S/x: expected a number from -10000 to 10000"));
  CHECK_THAT(shape(R"("plan": {"frames": {"S": {"x": 0}}})"), Catch::Matchers::StartsWith("/plan/frames/S"));
  CHECK_THAT(shape(R"("plan": {"devices": {"D": {"x": 0, "y": 0, "turn": 45}}})"),
             Catch::Matchers::StartsWith("/plan/devices/D/turn: expected one of `0`, `90`"));
  CHECK_THAT(shape(R"("plan": {"devices": {"two\nlines": {}}})"),
             Catch::Matchers::ContainsSubstring("control character"));
  CHECK_THAT(
      shape(R"("plan": {"background": {"file": "a/hall.svg", "x": 0, "y": 0, "width": 9}})"),
      Catch::Matchers::StartsWith("/plan/background/file: `a/hall.svg` is not the name of an .svg or .png file"));
  CHECK_THAT(shape(R"("view3d": {"model": "CELL.GLB"})"),
             Catch::Matchers::StartsWith("/view3d/model: `CELL.GLB` is not the name of a .glb file"));
  CHECK_THAT(shape(R"("view3d": {"nodes": {"D": {"P1": {"move": [0, 0, 0]}}}})"),
             Catch::Matchers::StartsWith("/view3d/nodes/D"));
  CHECK_THAT(shape(R"("view3d": {"nodes": {"D": {"node": "N", "P1": {"move": [0, 0]}}}})"),
             Catch::Matchers::StartsWith("/view3d/nodes/D/P1/move: expected an array of three numbers"));
}

TEST_CASE("A duration is exact, uniform between two values, or normal around a mean") {
  CHECK(takes("\"2s\"") == Duration::fixed(2 * tables::kSecond));
  CHECK(takes("\"0.000000001 s\"") == Duration::fixed(1));
  CHECK(takes("\"1.5h\"") == Duration::fixed(5400 * tables::kSecond));
  CHECK(takes(R"({"min": "1.8s", "max": "2.2s"})") ==
        Duration{Duration::Kind::uniform, 1800 * tables::kMillisecond, 2200 * tables::kMillisecond});
  CHECK(takes(R"({"min": "1s", "max": "1s"})")->kind == Duration::Kind::uniform);
  CHECK(takes(R"({"mean": "2s", "sigma": "0s"})") == Duration{Duration::Kind::normal, 2 * tables::kSecond, 0});
}

TEST_CASE("An invalid, a too fine and a too long duration have different messages") {
  const std::string none = "` is not a duration; write a number and ns, us, ms, s, min or h, such as `500ms`";
  CHECK(takes_fault("\"2 sec\"") == ": `2 sec" + none);
  CHECK(takes_fault("\"-2s\"") == ": `-2s" + none);
  CHECK(takes_fault("\"1e3s\"") == ": `1e3s" + none);
  CHECK(takes_fault("\"2\"") == ": `2" + none);
  CHECK(takes_fault("\".5s\"") == ": `.5s" + none);
  CHECK(takes_fault("\"0.1ns\"") == ": `0.1ns` has a part below 1 ns; give it fewer decimals");
  CHECK(takes_fault("\"1.0000000001 s\"") == ": `1.0000000001 s` has a part below 1 ns; give it fewer decimals");
  CHECK(takes_fault("\"3000000h\"") ==
        ": `3000000h` is longer than the maximum of 292 years; write a shorter duration");
  CHECK(takes_fault("2") ==
        ": expected a duration such as `500ms`, or an object with `min` and `max`, or one with `mean` "
        "and `sigma`, but found the number `2`");
  CHECK(takes_fault(R"({"min": "2s", "max": "1s"})") == "/max: `max` (`1s`) is less than `min`; exchange the two");
  CHECK(takes_fault(R"({"min": "2s", "mean": "1s"})").find("is unknown here") != std::string::npos);
  CHECK(takes_fault(R"({"min": "2s"})").find("`max` is missing here") != std::string::npos);
  CHECK(takes_fault(R"({"mean": "2s", "sigma": "x"})") == "/sigma: `x" + none);
}

TEST_CASE("Another version of the format and nonsense have different messages") {
  CHECK(refused(R"({"symplant": 2, "symbols": {"new": "shape"}})") ==
        "/symplant: this is version 2 of the format, but this symplant reads version 1; use a newer symplant");
  CHECK(refused(R"({"symplant": 0})") == "/symplant: unknown format version 0; write 1");
  CHECK(shape(description::read_plant_file(R"({"symplant": "1", "symbols": ["a"]})", "s")) ==
        "/symplant: expected the version of the format, 1, but found the text `1`");
  CHECK(shape(description::read_plant_file(R"({"symplant": 1.5, "symbols": ["a"]})", "s")) ==
        "/symplant: expected the version of the format, 1, but found the number `1.5`");
  CHECK(shape(description::read_plant_file(R"({"symbols": ["a"]})", "s")) ==
        ": the key `symplant` is missing here; it holds the version of the format, 1");
}

TEST_CASE("Another kind of JSON is reported as what it looks like") {
  CHECK(refused("[1]") ==
        ": this is not an object; a plant description is an object with `\"symplant\": 1` and `symbols`");
  CHECK(refused("{}") == ": this is JSON, but not a plant description, which has `\"symplant\": 1` and `symbols`");
  CHECK(refused(R"({"name": "x", "version": "1.0.0", "dependencies": {}})") ==
        "/dependencies: this looks like the package.json of a JavaScript package, not a plant description");
  CHECK(refused(R"({"symplant-scenario": 1, "steps": []})") ==
        "/symplant-scenario: this is a scenario; give it to `symplant run PLANT --scenario`");
  CHECK(refused(std::string(description::plant_schema())) ==
        "/$id: this looks like a JSON Schema, not a plant "
        "description");
}

TEST_CASE("Unknown keys are rejected with the nearest one, planned keys with a separate message") {
  CHECK(shape(R"("device": {})") == "/device: the key `device` is unknown here; did you mean `devices`?");
  CHECK(shape(R"("devices": {"D": {"transition": []}})") ==
        "/devices/D/transition: the key `transition` is unknown here; did you mean `transitions`?");
  CHECK(shape(R"("links": [{"url": "loop:", "wordorder": "low-first"}])") ==
        "/links/0/wordorder: the key `wordorder` is unknown here; did you mean `word-order`?");
}

TEST_CASE("A naming rule is a file, a profile, or an object that is kept as text") {
  CHECK(sound(R"("naming": "rules/naming.json")").naming == "rules/naming.json");
  CHECK(sound(R"("naming": "@ls-body")").naming == "@ls-body");
  const description::PlantFile file = sound(R"("naming": {"rules": []})");
  CHECK(file.naming.empty());
  CHECK(file.naming_text == R"({"rules":[]})");
  CHECK(shape(R"("naming": 1)") ==
        "/naming: expected a naming rule: the path of a naming.json, `@` and a ready profile, or the rule itself, but "
        "found the number `1`");
}

TEST_CASE("All faults of form are reported in one run") {
  CHECK(shape(R"("defaults": {"travel": 2}, "devices": {"D": {"only": 1, "actuation": "hold"}}, "name": "")") ==
        "/defaults/travel: expected a duration such as `500ms`, but found the number `2`\n"
        "/devices/D/actuation: expected one of `latched`, `bistable`, `held`, `spring`, but found the text "
        "`hold`; did you mean `held`?\n"
        "/devices/D/only: expected true or false, but found the number `1`\n"
        "/name: expected the plant's name, but found an empty text");
}

TEST_CASE("Invalid lists, controllers and classes are rejected") {
  const auto list = [](const std::string& members) {
    return shape(description::read_plant_file(R"({"symplant": 1, "symbols": [{"file": "a", )" + members + "}]}", "s"));
  };
  const std::string format = list(R"("format": "gxiec")");
  CHECK(format.starts_with("/symbols/0/format: unknown list format `gxiec`; choose one of `gx-iec`, "));
  CHECK(format.ends_with("; did you mean `gx-iec`?"));
  CHECK(list(R"("columns": {"name": "Tag", "address": 3, "sheet": "IO"}, "part": 2)").empty());
  CHECK(list(R"("columns": {"name": 0})").starts_with("/symbols/0/columns/name: "));
  CHECK(list(R"("part": 0)").starts_with("/symbols/0/part: "));
  CHECK(list(R"("encoding": "cp948")")
            .starts_with("/symbols/0/encoding: unknown encoding `cp948`; choose one of `utf-8`, `utf-16le`, "
                         "`utf-16be`, "
                         "`cp932`, `cp949`, "));
  CHECK(list(R"("encoding": "gb1803")").ends_with("`cp866`; did you mean `gb18030`?"));
  CHECK(list(R"("encoding": "Shift_JIS")").empty());
  CHECK(list(R"("controller": "A=B")").starts_with("/symbols/0/controller: `A=B` is not a valid controller name"));
  CHECK(list(R"("xy": "dec")").starts_with("/symbols/0/xy: expected one of `hex`, `octal`, but found the text `dec`"));
  CHECK(refused(R"({"symplant": 2})") != "");
  CHECK(shape(description::read_plant_file(R"({"symplant": 1, "symbols": []})", "s")) ==
        "/symbols: expected an array of symbol lists, but found an empty array");
  CHECK(shape(R"("devices": {"D": {"behaviour": "my stopper"}})") ==
        "/devices/D/behaviour: `my stopper` is not a valid C++ class name; use letters, digits and `_`");
  CHECK(shape(R"("devices": {"D": {"type": "2X"}})") ==
        "/devices/D/type: `2X` is not a valid C++ class name; use letters, digits and `_`");
}

TEST_CASE("Names may contain anything except control characters") {
  const std::string control = ": this name contains a control character, such as a line end; remove it";
  CHECK(shape(R"("name": "a\nb")") == "/name" + control);
  CHECK(shape(R"("devices": {"D": {"states": ["A", "B\u007f"]}})") == "/devices/D/states/1" + control);
  CHECK(shape(R"("requirements": [{"name": "\t", "never": "A"}])") == "/requirements/0/name" + control);
  CHECK(sound(R"("name": "Pr\u00e4zision 7-b */ '\"'")").name == "Pr\u00e4zision 7-b */ '\"'");
}

TEST_CASE("A requirement is a `never`, or an `after` with `expect` and `within`") {
  CHECK(shape(R"("requirements": [{"name": "a", "never": "A", "within": "1s"}])") != "");
  CHECK(shape(R"("requirements": [{"name": "a", "after": "A", "expect": "B"}])") ==
        "/requirements/0: the key `within` is missing here; it holds a duration such as `500ms`, or an object with "
        "`min` and `max`");
  CHECK(
      shape(R"("requirements": [{"name": "a", "after": "A", "expect": "B", "within": {"min": "2s", "max": "1s"}}])") ==
      "/requirements/0/within/max: `max` (`1s`) is less than `min`; exchange the two");
  CHECK(
      shape(
          R"("requirements": [{"name": "a", "after": "A", "expect": "B", "within": {"mean": "2s", "sigma": "1s"}}])") !=
      "");
  CHECK(shape(R"("requirements": [{"never": "A"}])") ==
        "/requirements/0: the key `name` is missing here; it holds the requirement's name");
}

TEST_CASE("An empty entry still wins, and every value of a pattern is kept as text") {
  const description::DeviceDescription d = device_of(R"("only": false, "transitions": [])");
  CHECK(d.gives(description::DeviceKey::only));
  CHECK(d.gives(description::DeviceKey::transitions));
  CHECK_FALSE(d.gives(description::DeviceKey::outputs));
  CHECK(d.texts.empty());
  const description::PlantFile file = sound(R"("devices": {"L_*": {"rest": "A"}})");
  CHECK(file.description.devices[0].texts[static_cast<std::size_t>(description::DeviceKey::rest)] == "\"A\"");
}

TEST_CASE("`sequence` is one of three words, in defaults and devices") {
  CHECK(sound("").description.defaults.sequence == description::Sequence::free);
  CHECK(sound(R"("defaults": {"sequence": "cycle"})").description.defaults.sequence == description::Sequence::cycle);
  CHECK_FALSE(device_of("").sequence);
  CHECK(device_of(R"("sequence": "neighbours")").sequence == description::Sequence::neighbours);
  CHECK(shape(R"("defaults": {"sequence": "circle"})") ==
        "/defaults/sequence: expected one of `free`, `neighbours`, `cycle`, but found the text `circle`; did you mean "
        "`cycle`?");
}

TEST_CASE("Braces in the entry of one device are an error at their location, except in quotes") {
  const std::string rest = " is replaced by a name only under a pattern, and `L_P_D` is one device; write the name";
  const auto entry = [](const std::string& members) { return "\"devices\": {\"L_P_D\": {" + members + "}}"; };
  CHECK(shape(entry(R"("transitions": [{"from": "A", "to": "B", "when": "{self}.A", "while": "not {1}.B"}])")) ==
        "/devices/L_P_D/transitions/0/when: `{self}`" + rest + "\n/devices/L_P_D/transitions/0/while: `{1}`" + rest);
  CHECK(shape(entry(R"("inputs": {"x": "{line}_P_E.A"}, "disables": {"A": ["L_P_E", "{line}_P_E"]})")) ==
        "/devices/L_P_D/inputs/x: `{line}`" + rest + "\n/devices/L_P_D/disables/A/1: `{line}`" + rest);
  CHECK(shape(entry(R"("inputs": {"x": "'A {1}'.ON"})")).empty());
}

TEST_CASE("`for` makes a requirement one for a pattern") {
  const std::string never = R"("never": "{self}.A"}])";
  CHECK(sound(R"("requirements": [{"name": "{self}", "for": "L_*", )" + never).description.requirements[0].of == "L_*");
  CHECK(sound(R"("requirements": [{"name": "a", )" + never).description.requirements[0].of.empty());
  CHECK(shape(R"("requirements": [{"name": "{self}", "for": "", )" + never).starts_with("/requirements/0/for: "));
}

TEST_CASE("Values of every wrong type are rejected without harm") {
  const std::vector<std::string> values{"null", "true", "1",    "-1.5", "\"x\"",
                                        "\"\"", "[]",   "[[]]", "{}",   "{\"x\": {}}"};
  const std::vector<std::string> keys{"symbols", "name", "defaults", "devices", "requirements", "links", "check"};
  for (const std::string& value : values) {
    for (const std::string& key : keys) {
      const PlantFileReading reading =
          description::read_plant_file("{\"symplant\": 1, \"" + key + "\": " + value + "}", "stem");
      CHECK(reading.file);
    }
    for (std::size_t k = 0; k < description::kDeviceKeys; ++k) {
      const std::string key(description::device_key_name(static_cast<description::DeviceKey>(k)));
      const PlantFileReading reading = read("\"devices\": {\"D\": {\"" + key + "\": " + value + "}}");
      CHECK(reading.file);
    }
  }
}

TEST_CASE("A file is a plant description by the suffix of its name or by its first character") {
  CHECK(description::is_plant_file("a/plant.json", "Class,Identifier"));
  CHECK(description::is_plant_file("a/plant.JSONC", ""));
  CHECK(description::is_plant_file("plant", "\xEF\xBB\xBF \r\n{"));
  CHECK(description::is_plant_file("plant", std::string_view("\xFF\xFE{\0", 4)));
  CHECK_FALSE(description::is_plant_file("symbols.csv", "Class,Identifier"));
  CHECK_FALSE(description::is_plant_file("symbols.csv", ""));
  CHECK_FALSE(description::is_plant_file(".json", ""));
}

}  // namespace
}  // namespace symplant::test

// Names of the matched device in entries of patterns, requirements for a pattern, and which numbered states join.
#include <algorithm>

#include "description_support.hpp"
#include "model/condition_text.hpp"
#include "symplant/tables/digest.hpp"

namespace symplant::test {
namespace {

/// Lines A and B, each with two clamps; only A has a door.
std::vector<std::string> cells() {
  std::vector<std::string> names;
  for (const std::string device : {"A_S1_CL1", "A_S1_CL2", "A_S1_DOOR", "B_S2_CL1", "B_S2_CL2"}) {
    for (const char* symbol : {"_O_RET", "_I_RET", "_O_ADV", "_I_ADV"}) names.push_back(device + symbol);
  }
  return names;
}

DeviceDescription guarded(std::string path, std::string when) {
  DeviceDescription d = device(std::move(path));
  d.transitions = {transition("RET", "ADV", "", std::move(when))};
  return d;
}

description::GivenRequirement never_for(std::string pattern, std::string name, std::string never) {
  description::GivenRequirement given;
  given.name = std::move(name);
  given.never = std::move(never);
  given.of = std::move(pattern);
  return given;
}

Analysed requiring(std::vector<description::GivenRequirement> requirements) {
  description::Description description;
  description.requirements = std::move(requirements);
  return analyse_described(bits(cells()), std::move(description));
}

std::string conditions(const Analysed& analysed, std::string_view path) {
  std::string text;
  for (const condition::Tree& tree : unit_of(analysed, path).conditions) {
    text += (text.empty() ? "" : "; ") + model::condition_text(tree, analysed.model());
  }
  return text;
}

std::string requirements(const Analysed& analysed) {
  std::string text;
  for (const model::Requirement& each : analysed.model().requirements) {
    text += each.name + ": " + model::condition_text(each.condition, analysed.model()) + "\n";
  }
  return text;
}

std::string warnings_in(const Analysed& analysed) {
  std::string text;
  for (const description::DescriptionFault& fault : analysed.evidence().warnings) {
    text += (text.empty() ? "" : "\n") + fault.pointer + ": " + fault.message;
  }
  return text;
}

TEST_CASE("Names in braces are those of each matched device") {
  const Analysed sound = described(cells(), {guarded("?_*_CL1", "{line}_{process}_CL2.moving or {1}_{2}_CL2.ADV")});
  CHECK(faults(sound) == "");
  CHECK(conditions(sound, "A_S1_CL1") == "A_S1_CL2.moving or A_S1_CL2.ADV");
  CHECK(conditions(sound, "B_S2_CL1") == "B_S2_CL2.moving or B_S2_CL2.ADV");
  const Analysed levels =
      described(cells(), {guarded("*_CL1", "not {self}_O_RET and '{line}_{process}_{device}'.RET")});
  CHECK(faults(levels) == "");
  CHECK(conditions(levels, "B_S2_CL1") == "not B_S2_CL1_O_RET and B_S2_CL1.RET");
}

TEST_CASE("A plant described by braces is the plant written out") {
  const auto hash = [](std::vector<DeviceDescription> devices, std::vector<description::GivenRequirement> required) {
    description::Description description = describing(std::move(devices));
    description.requirements = std::move(required);
    const CompiledText compiled = compile_described(bits(cells()), std::move(description));
    REQUIRE(compiled.compiled);
    return tables::model_hash(compiled.compiled->tables.tables());
  };
  DeviceDescription pattern = guarded("*_CL1", "{1}_CL2.RET");
  pattern.disables = {{"ADV", {"{line}_*_CL2"}}};
  DeviceDescription a = guarded("A_S1_CL1", "A_S1_CL2.RET");
  a.disables = {{"ADV", {"A_S1_CL2"}}};
  DeviceDescription b = guarded("B_S2_CL1", "B_S2_CL2.RET");
  b.disables = {{"ADV", {"B_S2_CL2"}}};
  CHECK(hash({pattern}, {never_for("*1", "{self} moves", "{self}.moving")}) ==
        hash({a, b},
             {never_for("", "A_S1_CL1 moves", "A_S1_CL1.moving"), never_for("", "B_S2_CL1 moves", "B_S2_CL1.moving")}));
}

TEST_CASE("`while` and inputs may have names in braces, too") {
  DeviceDescription d = guarded("*_CL1", "");
  d.transitions[0].during = "{line}_{process}_CL2.RET";
  d.behaviour = "Clamp";
  d.inputs = {{"other", "{line}_{process}_CL2.ADV"}};
  const Analysed list = described(cells(), {d});
  CHECK(faults(list) == "");
  CHECK(conditions(list, "A_S1_CL1") == "A_S1_CL2.RET; A_S1_CL2.ADV");
  CHECK(conditions(list, "B_S2_CL1") == "B_S2_CL2.RET; B_S2_CL2.ADV");
}

TEST_CASE("Where the plant lacks a name that braces make, the entry is left out with one warning") {
  DeviceDescription d = guarded("*_CL?", "{line}_{process}_DOOR.ADV");
  d.disables = {{"ADV", {"{line}_{process}_DOOR"}}};
  d.inputs = {{"door", "{line}_{process}_DOOR.moving"}};
  const Analysed list = described(cells(), {d});
  CHECK(faults(list) == "");
  CHECK(origins(unit_of(list, "A_S1_CL2")) == "gd");
  CHECK(origins(unit_of(list, "B_S2_CL2")) == "dd");
  CHECK(unit_of(list, "B_S2_CL2").conditions.empty());
  CHECK(unit_of(list, "A_S1_CL1").disables[1] == std::vector<std::uint32_t>{2});
  CHECK(unit_of(list, "B_S2_CL1").disables[1].empty());
  const std::string rest =
      ": device `B_S2_DOOR` not found; the entry is left out for `B_S2_CL1`, `B_S2_CL2`, 2 of the 4 matches";
  CHECK(warnings_in(list) == "/devices/*_CL?/disables/ADV/0" + rest + "\n/devices/*_CL?/inputs/door" + rest +
                                 "\n/devices/*_CL?/transitions/0/when" + rest);
}

TEST_CASE("An input is left out like a transition, and findings about the others name them") {
  DeviceDescription pattern = device("*_CL1");
  pattern.inputs = {{"a_door", "{line}_{process}_DOOR.ADV"}, {"b_both", "{self}.RET and {self}.ADV"}};
  DeviceDescription a = device("A_S1_CL1");
  a.behaviour = "ClampA";
  DeviceDescription b = device("B_S2_CL1");
  b.behaviour = "ClampB";
  const Analysed list = described(cells(), {pattern, a, b});
  CHECK(faults(list) == "");
  CHECK(conditions(list, "A_S1_CL1") == "A_S1_DOOR.ADV; A_S1_CL1.RET and A_S1_CL1.ADV");
  CHECK(conditions(list, "B_S2_CL1") == "B_S2_CL1.RET and B_S2_CL1.ADV");
  CHECK(unit_of(list, "B_S2_CL1").input_names == std::vector<std::string_view>{"b_both"});
  REQUIRE(list.count("condition-decided") == 2);
  for (const diag::Diagnostic& finding : list.diagnostics.all()) {
    if (finding.rule->slug == "condition-decided") CHECK(finding.message.starts_with("`{self}.RET and"));
  }
}

TEST_CASE("Devices of one behavior cannot differ in the inputs that are left out") {
  DeviceDescription pattern = device("*_CL1");
  pattern.behaviour = "Clamp";
  pattern.inputs = {{"door", "{line}_{process}_DOOR.ADV"}};
  CHECK(faults(described(cells(), {pattern})).find("which has other `inputs`") != std::string::npos);
}

TEST_CASE("A name that the plant lacks for every match is one error") {
  DeviceDescription d = guarded("*_CL?", "{line}_{process}_DOR.ADV");
  d.disables = {{"ADV", {"{self}X"}}};
  CHECK(faults(described(cells(), {d})) ==
        "/devices/*_CL?/disables/ADV/0: device `A_S1_CL1X` not found; did you mean `A_S1_CL1`? (the other 3 matches "
        "lack it too)\n/devices/*_CL?/transitions/0/when: device `A_S1_DOR` not found; did you mean `A_S1_DOOR`? (the "
        "other 3 matches lack it too)");
}

TEST_CASE("An unknown name in braces is one error with the names that are known") {
  CHECK(faults(described(cells(), {guarded("*_CL?", "{lin}_S1_DOOR.ADV")})) ==
        "/devices/*_CL?/transitions/0/when: `{lin}` is unknown here; use one of `{line}`, `{process}`, `{device}`, "
        "`{self}`, `{1}`, `{2}` (also for other devices that `*_CL?` matches)");
  for (const std::string text : {"{3}.ADV", "{0}.ADV", "{}.ADV", "{self.ADV", "{-1}.ADV", "{1x}.ADV"}) {
    CAPTURE(text);
    CHECK(faults(described(cells(), {guarded("*_CL?", text)})).find("is unknown here") != std::string::npos);
  }
}

TEST_CASE("A device cannot disable itself by braces") {
  DeviceDescription d = device("*_CL1");
  d.disables = {{"ADV", {"{self}"}}};
  CHECK(faults(described(cells(), {d})) ==
        "/devices/*_CL1/disables/ADV/0: `A_S1_CL1` disables itself; remove it (also for other devices that `*_CL1` "
        "matches)");
}

TEST_CASE("A requirement for a pattern is one for each device, in list order") {
  const Analysed list = requiring({never_for("*_CL?", "{self} {2}", "{self}.ADV and {1}_CL{2}.moving"),
                                   never_for("a_s1_door", "{device} of {line}", "{self}.ADV")});
  CHECK(faults(list) == "");
  CHECK(requirements(list) ==
        "A_S1_CL1 1: A_S1_CL1.ADV and A_S1_CL1.moving\nA_S1_CL2 2: A_S1_CL2.ADV and A_S1_CL2.moving\n"
        "B_S2_CL1 1: B_S2_CL1.ADV and B_S2_CL1.moving\nB_S2_CL2 2: B_S2_CL2.ADV and B_S2_CL2.moving\n"
        "DOOR of A: A_S1_DOOR.ADV\n");
}

TEST_CASE("A requirement is left out for devices where the plant lacks what it names") {
  const Analysed list = requiring({never_for("*_CL1", "{self}", "{self}.ADV and {line}_{process}_DOOR.ADV")});
  CHECK(faults(list) == "");
  CHECK(requirements(list) == "A_S1_CL1: A_S1_CL1.ADV and A_S1_DOOR.ADV\n");
  CHECK(warnings_in(list) ==
        "/requirements/0: device `B_S2_DOOR` not found; the entry is left out for `B_S2_CL1`, 1 of the 2 matches");
  CHECK(faults(requiring({never_for("*_CL1", "{self}", "{self}.OPEN")})) ==
        "/requirements/0: state `OPEN` of `A_S1_CL1` not found (the other match lacks it too)");
}

TEST_CASE("A fault of a requirement for a pattern is reported once") {
  const std::string others = " (also for others that `*_CL?` matches)";
  CHECK(faults(requiring({never_for("*_CL?", "same", "{self}.ADV")})) ==
        "/requirements/0/name: `same` already names another requirement; use `{self}` in the name" + others);
  CHECK(faults(requiring({never_for("*_CL?", "{self} {x}", "{self}.ADV")})).ends_with(others));
  CHECK(faults(requiring({never_for("*_CL?", "{self}", "{self}.ADV and")})).ends_with(others));
  CHECK(faults(requiring({never_for("*_CL?", "{self}", "A_S1_CL9.ADV")})).ends_with(others));
}

TEST_CASE("A pattern of requirements that matches no device is a warning") {
  const Analysed list = requiring({never_for("X*", "{self}", "{self}.ADV")});
  CHECK(faults(list) == "");
  CHECK(warnings_in(list) == "/requirements/0/for: `X*` matches no device");
}

TEST_CASE("Without `for` a requirement has no names in braces") {
  const std::string rest = " is replaced by a name only with `for`; add `for`, or write the name";
  CHECK(faults(requiring({never_for("", "{self}", "A_S1_CL1.ADV")})) == "/requirements/0/name: `{self}`" + rest);
  CHECK(faults(requiring({never_for("", "a", "{line}_S1_CL1.ADV")})) == "/requirements/0/never: `{line}`" + rest);
}

}  // namespace
}  // namespace symplant::test

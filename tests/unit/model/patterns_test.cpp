// Patterns: the entry that applies to each device, priorities, and parts that are left out.
#include "description_support.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kStoppers{"L_P_S1_O_ADV", "L_P_S1_I_ADV", "L_P_S1_O_RET", "L_P_S1_I_RET",
                                         "L_P_S2_O_ADV", "L_P_S2_I_ADV", "L_P_S2_O_RET", "L_P_S2_I_RET",
                                         "L_P_M_O_RUN1", "L_P_M_I_RUN1", "L_P_M_O_END2", "L_P_M_I_END2"};

DeviceDescription actuated(std::string path, tables::Actuation actuation) {
  DeviceDescription d = device(std::move(path));
  d.actuation = actuation;
  return d;
}

DeviceDescription with(std::string path, std::vector<GivenTransition> transitions) {
  DeviceDescription d = device(std::move(path));
  d.transitions = std::move(transitions);
  return d;
}

std::string warnings(const Analysed& analysed) {
  std::string text;
  for (const description::DescriptionFault& fault : analysed.evidence().warnings) {
    text += (text.empty() ? "" : "\n") + fault.pointer + ": " + fault.message;
  }
  return text;
}

TEST_CASE("A pattern applies to every device that it matches, in any case") {
  const Analysed list = described(kStoppers, {actuated("l_*_s?", tables::Actuation::held)});
  CHECK(unit_of(list, "L_P_S1").actuation == tables::Actuation::held);
  CHECK(unit_of(list, "L_P_S2").actuation == tables::Actuation::held);
  CHECK(unit_of(list, "L_P_M").actuation == tables::Actuation::latched);
  CHECK(faults(list) == "");
  CHECK(warnings(list) == "");
}

TEST_CASE("An exact name beats every pattern, key by key") {
  DeviceDescription pattern = actuated("L_P_S*", tables::Actuation::held);
  pattern.initial = "RET";
  const Analysed list = described(kStoppers, {actuated("L_P_S1", tables::Actuation::bistable), pattern});
  CHECK(unit_of(list, "L_P_S1").actuation == tables::Actuation::bistable);
  CHECK(unit_of(list, "L_P_S1").initial == 1);
  CHECK(unit_of(list, "L_P_S2").actuation == tables::Actuation::held);
}

TEST_CASE("A pattern with more literal characters beats another, key by key") {
  DeviceDescription wide = actuated("*", tables::Actuation::held);
  wide.initial = "RET";
  const Analysed list =
      described({"L_P_S1_O_ADV", "L_P_S1_I_ADV", "L_P_S1_O_RET", "L_P_S1_I_RET", "L_P_T_O_ADV", "L_P_T_O_RET"},
                {wide, actuated("*_S?", tables::Actuation::bistable)});
  CHECK(unit_of(list, "L_P_S1").actuation == tables::Actuation::bistable);
  CHECK(unit_of(list, "L_P_S1").initial == 1);
  CHECK(unit_of(list, "L_P_T").actuation == tables::Actuation::held);
}

TEST_CASE("An array replaces an array, even if empty") {
  DeviceDescription nothing = device("L_P_S1");
  nothing.given[static_cast<std::size_t>(description::DeviceKey::transitions)] = true;
  const Analysed list = described(kStoppers, {with("L_P_S*", {taking(transition("ADV", "RET"), 5)}),
                                              with("L_P_S2", {transition("RET", "ADV")}), nothing});
  CHECK(origins(unit_of(list, "L_P_S1")) == "dd");
  CHECK(transitions_text(list, unit_of(list, "L_P_S2")) == "RET-O_ADV>ADV ADV-O_RET>RET");
  CHECK(unit_of(list, "L_P_S2").transitions[1].takes == Duration::fixed(tables::kSecond));
}

TEST_CASE("An exact false overrides `only` of a pattern") {
  DeviceDescription only = device("L_P_S*");
  only.only = true;
  DeviceDescription not_only = device("L_P_S2");
  not_only.given[static_cast<std::size_t>(description::DeviceKey::only)] = true;
  const Analysed list = described(kStoppers, {only, not_only});
  CHECK(unit_of(list, "L_P_S1").transitions.empty());
  CHECK(unit_of(list, "L_P_S2").transitions.size() == 2);
}

TEST_CASE("Two equally specific patterns must agree, unless a more specific one decides") {
  const auto saying = [](std::string path, std::string text) {
    DeviceDescription d = actuated(std::move(path), tables::Actuation::held);
    d.texts.resize(description::kDeviceKeys);
    d.texts[static_cast<std::size_t>(description::DeviceKey::actuation)] = std::move(text);
    return d;
  };
  const std::string fault =
      "/devices/L_?_S*/actuation: `L_?_S*` and `L_P_*` are equally specific and give `actuation` of `L_P_S1` "
      "different values; make one more specific or name the device";
  CHECK(faults(described(kStoppers, {saying("L_P_*", "\"held\""), saying("L_?_S*", "\"held\"")})) == "");
  CHECK(faults(described(kStoppers, {saying("L_P_*", "\"held\""), saying("L_?_S*", "\"spring\"")})) == fault);
  CHECK(faults(described(kStoppers, {saying("L_P_*", "\"held\""), saying("L_?_S*", "\"spring\""),
                                     saying("L_P_S?", "\"bistable\"")})) == "");
}

TEST_CASE("Two equally specific patterns that disagree are a fault with both locations, reported once") {
  DeviceDescription first = actuated("L_P_S*", tables::Actuation::held);
  DeviceDescription second = actuated("L_?_S?*", tables::Actuation::spring);
  second.path = "*L_P_S?";
  for (DeviceDescription* d : {&first, &second}) {
    d->texts.resize(description::kDeviceKeys);
    d->texts[static_cast<std::size_t>(description::DeviceKey::actuation)] = d == &first ? "\"held\"" : "\"spring\"";
  }
  const Analysed list = described(kStoppers, {first, second});
  CHECK(faults(list) ==
        "/devices/*L_P_S?/actuation: `*L_P_S?` and `L_P_S*` are equally specific and give `actuation` of `L_P_S1` "
        "different values; make one more specific or name the device");
  REQUIRE_FALSE(list.evidence().faults.empty());
  CHECK(list.evidence().faults.front().related == "/devices/L_P_S*/actuation");
  CHECK(list.evidence().faults.front().kind == description::FaultKind::patterns);
  CHECK(faults(described(kStoppers, {first, second, actuated("L_P_S1", tables::Actuation::held),
                                     actuated("L_P_S2", tables::Actuation::held)})) == "");
}

TEST_CASE("A pattern that matches no device is a warning") {
  const Analysed list = described(kStoppers, {actuated("L_*_DOOR?", tables::Actuation::held)});
  CHECK(faults(list) == "");
  CHECK(warnings(list) == "/devices/L_*_DOOR?: `L_*_DOOR?` matches no device");
}

TEST_CASE("Under a pattern an entry is omitted for devices that lack what it names, with a warning") {
  const Analysed list = described(
      kStoppers, {with("L_P_*", {taking(transition("ADV", "RET"), 5), taking(transition("RUN1", "END2"), 6)})});
  CHECK(faults(list) == "");
  CHECK(transitions_text(list, unit_of(list, "L_P_S1")) == "ADV-O_RET>RET RET-O_ADV>ADV");
  CHECK(unit_of(list, "L_P_S1").transitions[0].takes == Duration::fixed(5));
  CHECK(unit_of(list, "L_P_M").transitions[0].takes == Duration::fixed(6));
  CHECK(
      warnings(list) ==
      "/devices/L_P_*/transitions/0/from: 1 of the 3 devices that take this entry from `L_P_*` has no state `ADV`; the "
      "entry is left out for `L_P_M`\n"
      "/devices/L_P_*/transitions/0/to: 1 of the 3 devices that take this entry from `L_P_*` has no state `RET`; the "
      "entry is left out for `L_P_M`\n"
      "/devices/L_P_*/transitions/1/from: 2 of the 3 devices that take this entry from `L_P_*` have no state `RUN1`; "
      "the entry is left out for `L_P_S1`, `L_P_S2`\n"
      "/devices/L_P_*/transitions/1/to: 2 of the 3 devices that take this entry from `L_P_*` have no state `END2`; the "
      "entry is left out for `L_P_S1`, `L_P_S2`");
}

TEST_CASE("A name that all matched devices lack is an error") {
  DeviceDescription d = with("L_P_S?", {transition("ADV", "REF"), transition("ADV", "RET", "RETT")});
  d.initial = "HOME";
  d.outputs = {{"ADV", {{"BUSY", true}}, {}}};
  const Analysed list = described(kStoppers, {d});
  const std::string too = " (the other device that takes this entry from `L_P_S?` lacks it too)";
  CHECK(faults(list) ==
        "/devices/L_P_S?/initial: state `HOME` of `L_P_S1` not found" + too +
            "\n/devices/L_P_S?/outputs/ADV/enter/BUSY: event `BUSY` of `L_P_S1` not found" + too +
            "\n/devices/L_P_S?/transitions/0/to: state `REF` of `L_P_S1` not found; did you mean `RET`?" + too +
            "\n/devices/L_P_S?/transitions/1/on: operation `RETT` of `L_P_S1` not found; did you mean `RET`?" + too);
  CHECK(warnings(list) == "");
}

TEST_CASE("A name is no slip if a matched device has it but takes the key from elsewhere") {
  DeviceDescription wide = device("L_P_*");
  wide.initial = "RUN1";
  DeviceDescription exact = device("L_P_M");
  exact.initial = "END2";
  const Analysed list = described(kStoppers, {exact, wide});
  CHECK(faults(list) == "");
  CHECK(warnings(list) ==
        "/devices/L_P_*/initial: 2 of the 2 devices that take this entry from `L_P_*` have no state `RUN1`; the entry "
        "is left out for `L_P_S1`, `L_P_S2`");
}

TEST_CASE("A name in braces is no slip if a matched device has what it makes but takes the key from elsewhere") {
  const auto wide = [](const std::string& when) {
    DeviceDescription pattern = with("L_P_*", {transition("ADV", "RET", "", when)});
    pattern.disables = {{"ADV", {"{self}X"}}};
    return pattern;
  };
  DeviceDescription exact = with("L_P_M", {transition("RUN1", "END2")});
  exact.disables = {{"RUN1", {"L_P_S1"}}};
  const Analysed list = described(kStoppers, {exact, wide("not {self}.RUN1")});
  CHECK(warnings(list) ==
        "/devices/L_P_*/transitions/0/when: state `RUN1` of `L_P_S1` not found; the entry is left out for `L_P_S1`, "
        "`L_P_S2`; the other matches override it");
  CHECK(unit_of(list, "L_P_S1").left_out == std::vector<std::uint32_t>{0});
  // Nothing has the name of a device that the entry of `disables` makes.
  CHECK(faults(list).starts_with("/devices/L_P_*/disables/ADV/0: device `L_P_S1X` not found"));
  const Analysed slip = described(kStoppers, {exact, wide("not {self}.RUN")});
  CHECK(contains(faults(slip), "/devices/L_P_*/transitions/0/when: state `RUN` of `L_P_S1` not found"));
  CHECK(warnings(slip) == "");
}

TEST_CASE("An initial state, a rest state, outputs and disables are omitted, too") {
  DeviceDescription d = device("L_P_*");
  d.initial = "RET";
  d.outputs = {{"ADV", {}, {{"RUN1", false}}}, {"RUN1", {{"END2", true}}, {}}};
  d.disables = {{"ADV", {"L_P_M"}}, {"RUN1", {"L_P_S?"}}};
  d.disables[0].devices = {"*_M"};
  const Analysed list = described(kStoppers, {d});
  CHECK(faults(list) == "");
  CHECK(unit_of(list, "L_P_S1").initial == 1);
  CHECK(unit_of(list, "L_P_M").initial == 0);
  CHECK(unit_of(list, "L_P_M").initial_from != model::InitialFrom::description);
  CHECK(unit_of(list, "L_P_M").outputs[0].enter.size() == 1);
  CHECK(unit_of(list, "L_P_M").disables[0] == std::vector<std::uint32_t>{0, 1});
  CHECK(unit_of(list, "L_P_S1").disables[0] == std::vector<std::uint32_t>{2});
  CHECK(list.evidence().warnings.size() == 7);
}

TEST_CASE("A state that only an omitted entry would make a command stays a state") {
  // O_GO is `on` of a transition to P2; L_P_B has no P2, so its O_GO has no entry.
  const std::vector<std::string> names{"L_P_A_O_GO", "L_P_A_I_P1", "L_P_A_O_P1", "L_P_A_I_P2",
                                       "L_P_A_O_P2", "L_P_B_O_GO", "L_P_B_I_P1", "L_P_B_O_P1"};
  const Analysed list = described(names, {with("L_P_?", {transition("P1", "P2", "GO")})});
  CHECK(states_text(unit_of(list, "L_P_A")) == "P1 P2");
  CHECK(states_text(unit_of(list, "L_P_B")) == "P1 GO");
  CHECK(unit_of(list, "L_P_B").left_out == std::vector<std::uint32_t>{0});
}

TEST_CASE("The condition of an omitted entry is no condition of the device") {
  GivenTransition left = transition("RUN1", "END2", "", "L_P_S1.ADV");
  GivenTransition stays = transition("ADV", "RET", "", "L_P_M.END2");
  const Analysed list = described(kStoppers, {with("L_P_*", {left, stays})});
  REQUIRE(unit_of(list, "L_P_S1").conditions.size() == 1);
  CHECK(unit_of(list, "L_P_S1").transitions[0].when == 0);
  REQUIRE(unit_of(list, "L_P_M").conditions.size() == 1);
}

TEST_CASE("A commanded transition under a pattern is omitted if its target has no operation") {
  const std::vector<std::string> names{"L_P_A_O_P1", "L_P_A_I_P1", "L_P_A_O_P2", "L_P_A_I_P2", "L_P_A_O_P3",
                                       "L_P_B_O_P1", "L_P_B_I_P1", "L_P_B_I_P2", "L_P_B_O_P3"};
  const Analysed list = described(names, {with("L_P_?", {transition("P1", "P2")})});
  CHECK(faults(list) == "");
  CHECK(warnings(list) ==
        "/devices/L_P_?/transitions/0/to: 1 of the 2 devices that take this entry from `L_P_?` has no operation `P2`; "
        "the entry is left out for `L_P_B`");
}

TEST_CASE("A fault under a pattern is reported once for all its devices") {
  CHECK(faults(described(kStoppers, {with("L_P_S?", {transition("ADV", "ADV")})})) ==
        "/devices/L_P_S?/transitions/0: a transition cannot lead from `ADV` to itself; name two states (also for other "
        "devices that `L_P_S?` matches)");
  DeviceDescription rest = device("L_P_S?");
  rest.rest = "RET";
  CHECK(faults(described(kStoppers, {rest})).starts_with("/devices/L_P_S?/rest: `L_P_S1` is `latched`"));
}

TEST_CASE("A fault refers to the entry with the key") {
  DeviceDescription exact = actuated("L_P_S1", tables::Actuation::held);
  const Analysed list = described(kStoppers, {exact, with("L_P_S*", {transition("ADV", "RET", "", "L_P_X.RUN")})});
  REQUIRE(list.evidence().faults.size() == 1);
  CHECK(list.evidence().faults[0].pointer == "/devices/L_P_S*/transitions/0/when");
  CHECK(list.evidence().faults[0].kind == description::FaultKind::condition);
}

TEST_CASE("A pattern in `disables` excludes the device itself, and may match nothing") {
  DeviceDescription d = device("L_P_S1");
  d.disables = {{"ADV", {"L_P_*", "L_P_M"}}, {"RET", {"*_DOOR"}}};
  const Analysed list = described(kStoppers, {d});
  CHECK(faults(list) == "");
  CHECK(unit_of(list, "L_P_S1").disables[0] == std::vector<std::uint32_t>{1, 2});
  CHECK(warnings(list) == "/devices/L_P_S1/disables/RET/0: `*_DOOR` matches no device");
  d.disables = {{"ADV", {"L_P_S1"}}};
  CHECK(faults(described(kStoppers, {d})) == "/devices/L_P_S1/disables/ADV/0: `L_P_S1` disables itself; remove it");
}

TEST_CASE("A device that is too large is a fault of its exact name, not of a pattern") {
  std::vector<std::string> names{"L_P_A_O_ADV", "L_P_A_O_RET"};
  for (int i = 0; i < 70; ++i) names.push_back("L_P_BIG_O_T" + std::to_string(i));
  CHECK(faults(described(names, {actuated("L_P_*", tables::Actuation::held)})) == "");
  CHECK(faults(described(names, {actuated("L_P_BIG", tables::Actuation::held)})) ==
        "/devices/L_P_BIG: `L_P_BIG` has too many symbols for a device and is not modelled; remove its description");
}

TEST_CASE("A device described twice is reported with both locations") {
  const Analysed list =
      described(kStoppers, {actuated("L_P_S1", tables::Actuation::held), actuated("l_p_s1", tables::Actuation::held)});
  CHECK(faults(list) == "/devices/l_p_s1: `l_p_s1` is described twice; merge both");
  REQUIRE_FALSE(list.evidence().faults.empty());
  CHECK(list.evidence().faults[0].related == "/devices/L_P_S1");
}

TEST_CASE("`--verbose` counts the devices of each pattern") {
  const Analysed list =
      described(kStoppers, {actuated("L_P_S?", tables::Actuation::held), actuated("*M", tables::Actuation::held)});
  CHECK(list.evidence().decisions == std::vector<std::string>{"`L_P_S?` matches 2 devices", "`*M` matches 1 device"});
}

TEST_CASE("Devices with the same entries share the joined result, and a single entry is not joined") {
  const Analysed list =
      described(kStoppers, {actuated("L_P_S?", tables::Actuation::held), with("L_*_S?", {transition("ADV", "RET")}),
                            actuated("L_P_M", tables::Actuation::held)});
  CHECK(list.model().joined.size() == 1);
  CHECK(unit_of(list, "L_P_S1").described == unit_of(list, "L_P_S2").described);
  CHECK(unit_of(list, "L_P_M").described == &list.model().description->devices[2]);
}

TEST_CASE("A question mark is one character, in any script") {
  const std::vector<std::string> names{"L_P_\u00c4_O_ADV", "L_P_\u00c4_O_RET"};
  const Analysed list = described(names, {actuated("L_P_?", tables::Actuation::held)});
  CHECK(unit_of(list, "L_P_\u00c4").actuation == tables::Actuation::held);
  CHECK(warnings(described(names, {actuated("L_P_??", tables::Actuation::held)})) ==
        "/devices/L_P_??: `L_P_??` matches no device");
}

TEST_CASE("An entry omitted for a device is not checked for it") {
  DeviceDescription pattern = device("L_P_*");
  pattern.rest = "RET";
  pattern.disables = {{"ADV", {"L_P_M"}}};
  pattern.transitions = {taking(transition("ADV", "RET"), 5)};
  pattern.transitions[0].once = true;
  DeviceDescription spring = actuated("L_P_S?", tables::Actuation::spring);
  spring.given[static_cast<std::size_t>(description::DeviceKey::transitions)] = true;
  // L_P_M is not a spring, would disable itself, and as a held device may not have `once`.
  CHECK(faults(described(kStoppers, {pattern, spring, actuated("L_P_M", tables::Actuation::held)})) == "");
}

}  // namespace
}  // namespace symplant::test

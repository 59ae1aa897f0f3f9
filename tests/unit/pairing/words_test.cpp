// Facets by tasks: pairs, sensors, fan-out, data.
#include <string>
#include <vector>

#include "unit/pairing/pairing_support.hpp"

namespace symplant::pairing {
namespace {

const char* const kPattern = "{process}_{class}_{device...}_{task:known}";

std::string facets(const std::string& pattern, const std::vector<std::string>& symbols) {
  return Paired(naming_of(pattern), symbols).facets();
}

TEST_CASE("Operations and events of one position are linked, and those of its pair are of the same facet") {
  const Paired paired(naming_of(kPattern),
                      {"Q S1_SOL_GATE_ADV", "Q S1_SOL_GATE_RET", "I S1_LS_GATE_ADV", "I S1_LS_GATE_RET"});
  CHECK(paired.facets() == "S1_GATE: S1_SOL_GATE_ADV>ADV S1_SOL_GATE_RET>RET S1_LS_GATE_ADV<ADV S1_LS_GATE_RET<RET");
  CHECK(paired.facet(0).states == std::vector<std::string>{"RET", "ADV"});
  CHECK(paired.facet(0).first_is_rest);
  CHECK(paired.facet(0).base == nullptr);
}

TEST_CASE("Nothing is linked without an operation and an event of one device") {
  const Paired paired(naming_of(kPattern), {"Q S1_SOL_GATE_ADV", "I S1_LS_DOOR_ADV", "I S2_LS_GATE_ADV"});
  CHECK(paired.facets().empty());
  CHECK(paired.of(name::Account::no_event) == "S1_SOL_GATE_ADV");
  CHECK(paired.of(name::Account::no_operation) == "S1_LS_DOOR_ADV S2_LS_GATE_ADV");
}

TEST_CASE("Symbols of two controllers are not linked") {
  CHECK(facets(kPattern, {"Q S1_SOL_GATE_ADV", "1I S1_LS_GATE_ADV"}).empty());
}

TEST_CASE("A device whose tasks do not exclude each other has several facets, named by their states") {
  CHECK(facets("{process}_{device}_{task...}",
               {"Q S1_RB_ADV", "I S1_RB_ADV", "I S1_RB_RET", "Q S1_RB_WORK A", "I S1_RB_WORK A"}) ==
        "S1_RB.RET_ADV: S1_RB_ADV>ADV S1_RB_ADV<ADV S1_RB_RET<RET | "
        "S1_RB.WORK_A: S1_RB_WORK A>WORK_A S1_RB_WORK A<WORK_A");
}

TEST_CASE("With sequence numbers all numbered tasks of a device are one facet") {
  name::Naming naming = naming_of("{process}_{device}_{task...}");
  naming.tasks.sequence = true;
  const Paired paired(naming, {"Q S1_MC_RUN2", "I S1_MC_IDLE1", "I S1_MC_RUN2"});
  CHECK(paired.facets() == "S1_MC: S1_MC_RUN2>RUN2 S1_MC_IDLE1<IDLE1 S1_MC_RUN2<RUN2");
  CHECK(paired.facet(0).numbered);
}

TEST_CASE("Several sensors of a state are switched together") {
  const Paired paired(naming_of(kPattern), {"Q S1_SOL_GATE_ADV", "Q S1_SOL_GATE_RET", "I S1_LS_GATE_ADV1",
                                            "I S1_LS_GATE_ADV2", "I S1_LS_GATE_RET"});
  CHECK(paired.facets() ==
        "S1_GATE: S1_SOL_GATE_ADV>ADV S1_SOL_GATE_RET>RET S1_LS_GATE_ADV1<ADV S1_LS_GATE_ADV2<ADV2 S1_LS_GATE_RET<RET");
  const auto& outputs = paired.facet(0).base->outputs;
  REQUIRE(outputs.size() == 1);
  CHECK(outputs[0].state == "ADV");
  CHECK(outputs[0].enter == std::vector<std::pair<std::string, bool>>{{"ADV2", true}});
  CHECK(outputs[0].leave == std::vector<std::pair<std::string, bool>>{{"ADV2", false}});
}

TEST_CASE("A second operation of a state also leads to it") {
  name::Naming naming = naming_of("{process}_{device}_{task...}");
  naming.tasks.operation_affixes = {"START"};
  const Paired paired(naming, {"Q S1_RB_ADV", "Q S1_RB_ADV START", "I S1_RB_ADV", "I S1_RB_RET"});
  CHECK(paired.facets() == "S1_RB: S1_RB_ADV>ADV S1_RB_ADV START>ADV_START S1_RB_ADV<ADV S1_RB_RET<RET");
  const auto& transitions = paired.facet(0).base->transitions;
  REQUIRE(transitions.size() == 1);
  CHECK(transitions[0].from == "*");
  CHECK(transitions[0].to == "ADV");
  CHECK(transitions[0].on == "ADV_START");
}

TEST_CASE("With one command for two positions a spring leads to the other") {
  const Paired paired(naming_of(kPattern), {"Q S1_SOL_PIN_DOWN", "I S1_LS_PIN_UP"});
  CHECK(paired.facets() == "S1_PIN: S1_SOL_PIN_DOWN>DOWN S1_LS_PIN_UP<UP");
  REQUIRE(paired.facet(0).base != nullptr);
  CHECK(paired.facet(0).base->actuation == tables::Actuation::spring);
  CHECK(paired.facet(0).base->rest == "UP");
}

TEST_CASE("Each numbered operation is a separate facet with its sensors") {
  CHECK(facets(kPattern, {"Q S1_SOL_JIG_CLAMP1", "Q S1_SOL_JIG_CLAMP2", "I S1_LS_JIG_CLAMP1", "I S1_LS_JIG_CLAMP2",
                          "I S1_LS_JIG_UNCLAMP2"}) ==
        "S1_JIG.CLAMP1: S1_SOL_JIG_CLAMP1>CLAMP1 S1_LS_JIG_CLAMP1<CLAMP1 | "
        "S1_JIG.UNCLAMP2_CLAMP2: S1_SOL_JIG_CLAMP2>CLAMP2 S1_LS_JIG_CLAMP2<CLAMP2 S1_LS_JIG_UNCLAMP2<UNCLAMP2");
}

TEST_CASE("An appended digit numbers the sensors of a numbered operation") {
  name::Naming naming = naming_of(kPattern);
  naming.tasks.sensor_index = name::SensorIndex::appended;
  CHECK(Paired(naming, {"Q S1_SOL_JIG_CLAMP3", "I S1_LS_JIG_UNCLAMP31", "I S1_LS_JIG_UNCLAMP32"}).facets() ==
        "S1_JIG: S1_SOL_JIG_CLAMP3>CLAMP3 S1_LS_JIG_UNCLAMP31<UNCLAMP3 S1_LS_JIG_UNCLAMP32<UNCLAMP32");
}

TEST_CASE("A sensor may number its device") {
  CHECK(facets(kPattern, {"Q S1_SOL_LOCK_CLAMP_ADV", "I S1_LS_LOCK_CLAMP1_ADV", "I S1_LS_LOCK_CLAMP2_ADV"}) ==
        "S1_LOCK_CLAMP: S1_SOL_LOCK_CLAMP_ADV>ADV S1_LS_LOCK_CLAMP1_ADV<ADV S1_LS_LOCK_CLAMP2_ADV<CLAMP2_ADV");
}

TEST_CASE("With fan-out an operation drives the devices whose words contain its own, the closest first") {
  name::Naming naming = naming_of(kPattern);
  naming.rules[0].fan_out = true;
  const Paired paired(naming, {"Q S1_SOL_CLAMP_ADV", "Q S1_SOL_CLAMP_LH_ADV", "I S1_LS_CLAMP_RH_ADV",
                               "I S1_LS_1ST_CLAMP_RH_ADV", "I S1_LS_CLAMP_UPPER_LH_ADV", "I S2_LS_CLAMP_RH_ADV"});
  CHECK(paired.facets() ==
        "S1_CLAMP: S1_SOL_CLAMP_ADV>ADV S1_LS_CLAMP_RH_ADV<ADV S1_LS_1ST_CLAMP_RH_ADV<1ST_RH_ADV | "
        "S1_CLAMP_LH: S1_SOL_CLAMP_LH_ADV>ADV S1_LS_CLAMP_UPPER_LH_ADV<ADV");
  CHECK(paired.of(name::Account::no_operation) == "S2_LS_CLAMP_RH_ADV");
}

TEST_CASE("Without fan-out an operation drives its own device only") {
  CHECK(facets(kPattern, {"Q S1_SOL_CLAMP_ADV", "I S1_LS_CLAMP_RH_ADV"}).empty());
}

TEST_CASE("Symbols of one text are data") {
  name::Naming naming = naming_of("{process}_{device}_{task}");
  naming.normalise.replace.push_back({"_X[0-9]+$", ""});
  const Paired paired(naming, {"Q S1_RB_GO_X1", "I S1_RB_GO_X2", "I S1_RB_GO_X3"});
  CHECK(paired.facets().empty());
  CHECK(paired.of(name::Account::data) == "S1_RB_GO_X2 S1_RB_GO_X3");
}

TEST_CASE("Numbers that are weights are data unless both sides have them, numbers that count are not") {
  const std::string pattern = "{process}_{device}_{task...}";
  const Paired weights(naming_of(pattern), {"Q S1_RB_JOB 1", "Q S1_RB_JOB 2", "Q S1_RB_JOB 4", "Q S1_RB_JOB 8",
                                            "I S1_RB_AT 1", "I S1_RB_AT 10"});
  CHECK(weights.facets().empty());
  CHECK(weights.of(name::Account::data) == "S1_RB_JOB 1 S1_RB_JOB 2 S1_RB_JOB 4 S1_RB_JOB 8");
  const Paired both(naming_of(pattern), {"Q S1_RB_JOB 1", "Q S1_RB_JOB 2", "Q S1_RB_JOB 4", "Q S1_RB_JOB 8",
                                         "I S1_RB_JOB 1", "I S1_RB_JOB 2", "I S1_RB_JOB 4", "I S1_RB_JOB 8"});
  CHECK(both.of(name::Account::data).empty());
  const Paired count(naming_of(pattern), {"Q S1_RB_JOB 1", "Q S1_RB_JOB 2", "Q S1_RB_JOB 3", "Q S1_RB_JOB 4",
                                          "Q S1_RB_JOB 8", "I S1_RB_JOB 1"});
  CHECK(count.of(name::Account::data).empty());
  CHECK(count.facets() == "S1_RB: S1_RB_JOB 1>JOB_1 S1_RB_JOB 1<JOB_1");
}

/// The facets of all devices.
std::string devices(name::Naming naming, const std::vector<std::string>& symbols) {
  return Paired(std::move(naming), symbols, Extent::devices).facets();
}

TEST_CASE("A device exists as soon as one symbol names it") {
  CHECK(devices(naming_of(kPattern), {"Q S1_SOL_GATE_ADV"}) == "S1_GATE: S1_SOL_GATE_ADV>ADV");
  CHECK(devices(naming_of(kPattern), {"I S1_LS_GATE_ADV"}) == "S1_GATE: S1_LS_GATE_ADV<ADV?");
  CHECK(devices(naming_of(kPattern), {"W S1_LS_GATE_ADV"}) == "S1_GATE: S1_LS_GATE_ADV#");
  CHECK(devices(naming_of(kPattern), {"Q S1_SOL_GATE_ADV", "Q S1_SOL_GATE_RET"}) ==
        "S1_GATE: S1_SOL_GATE_ADV>ADV S1_SOL_GATE_RET>RET");
}

TEST_CASE("Devices are in the order of their first symbol, whatever it is") {
  CHECK(devices(naming_of(kPattern), {"W S1_LS_C_ADV", "I S1_LS_B_ADV", "Q S1_SOL_A_ADV"}) ==
        "S1_C: S1_LS_C_ADV# | S1_B: S1_LS_B_ADV<ADV? | S1_A: S1_SOL_A_ADV>ADV");
}

TEST_CASE("The only linked facet of a device takes its events and numbers, and keeps its name") {
  CHECK(devices(naming_of(kPattern), {"Q S1_SOL_GATE_ADV", "I S1_LS_GATE_ADV", "I S1_LS_GATE_UP", "W S1_LS_GATE_OPEN",
                                      "Q S1_SOL_GATE_LOCK"}) ==
        "S1_GATE: S1_SOL_GATE_ADV>ADV S1_LS_GATE_ADV<ADV S1_LS_GATE_UP<UP? S1_LS_GATE_OPEN# | "
        "S1_GATE.LOCK: S1_SOL_GATE_LOCK>LOCK");
}

TEST_CASE("A device of several facets has one more for the events and numbers that nothing links") {
  CHECK(devices(naming_of(kPattern), {"Q S1_SOL_GATE_ADV", "Q S1_SOL_GATE_UP", "I S1_LS_GATE_OPEN"}) ==
        "S1_GATE.ADV: S1_SOL_GATE_ADV>ADV | S1_GATE.UP: S1_SOL_GATE_UP>UP | S1_GATE: S1_LS_GATE_OPEN<OPEN?");
}

TEST_CASE("Events that nothing links make states if the rule says so") {
  name::Naming naming = naming_of(kPattern);
  naming.rules[0].unlinked_states = true;
  CHECK(devices(naming, {"I S1_LS_GATE_ADV"}) == "S1_GATE: S1_LS_GATE_ADV<ADV");
}

TEST_CASE("A unit gets no more events than it may have, and no second one of a task") {
  std::vector<std::string> symbols;
  for (int i = 0; i < 70; ++i) symbols.push_back("I S1_LS_GATE_X" + std::to_string(i));
  const Paired many(naming_of("{process}_LS_{device}_{task...}"), symbols, Extent::devices);
  REQUIRE(many.pairing.facets.size() == 1);
  CHECK(many.facet(0).members.size() == 64);
  name::Naming naming = naming_of(kPattern);
  naming.links = {{"S1_SOL_GATE_UP", "S1_LS_GATE_UP", "ADV"}};
  CHECK(devices(naming, {"Q S1_SOL_GATE_UP", "I S1_LS_GATE_UP", "I S1_LS_GATE_ADV"}) ==
        "S1_GATE: S1_SOL_GATE_UP>ADV S1_LS_GATE_UP<ADV");
}

TEST_CASE("Symbols of a role make no device") {
  name::Naming naming = naming_of(kPattern);
  naming.rules[0].role = name::Role::operator_panel;
  CHECK(devices(naming, {"Q S1_SOL_GATE_ADV", "I S1_LS_GATE_ADV"}).empty());
}

TEST_CASE("Two ends of a motion that differ by a number are one unit") {
  CHECK(facets(kPattern, {"Q S1_SOL_TT_RET0", "I S1_LS_TT_RET0", "Q S1_SOL_TT_ADV90", "I S1_LS_TT_ADV90"}) ==
        "S1_TT: S1_SOL_TT_RET0>RET0 S1_LS_TT_RET0<RET0 S1_SOL_TT_ADV90>ADV90 S1_LS_TT_ADV90<ADV90");
  // Two valves each have their own number at both ends.
  CHECK(facets(kPattern, {"Q S1_SOL_TT_ADV1", "I S1_LS_TT_ADV1", "Q S1_SOL_TT_ADV2", "I S1_LS_TT_ADV2"}) ==
        "S1_TT.ADV1: S1_SOL_TT_ADV1>ADV1 S1_LS_TT_ADV1<ADV1 | S1_TT.ADV2: S1_SOL_TT_ADV2>ADV2 S1_LS_TT_ADV2<ADV2");
}

TEST_CASE("The words of a pair may be numbers") {
  name::Naming naming = naming_of("{process}_{class}_{device}_{task...}");
  naming.tasks.pairs = {{"0", "90"}};
  const Paired paired(naming, {"Q S1_SOL_TT_0_DEG", "I S1_LS_TT_0_DEG", "Q S1_SOL_TT_90_DEG", "I S1_LS_TT_90_DEG"});
  REQUIRE(paired.pairing.facets.size() == 1);
  CHECK(paired.facet(0).states == std::vector<std::string>{"0_DEG", "90_DEG"});
  CHECK(paired.facet(0).first_is_rest);
}

TEST_CASE("What is not linked is accounted for by its role") {
  name::Naming naming = naming_of(kPattern);
  name::SymbolRule panel = rule_of("{device...}_(PL|PB)");
  panel.role = name::Role::operator_panel;
  name::SymbolRule normal = rule_of("{device...}_NORMAL");
  normal.role = name::Role::constant;
  normal.value = false;
  naming.rules.push_back(panel);
  naming.rules.push_back(normal);
  naming.ignore = {"SPARE*"};
  const Paired paired(naming, {"I START_PB", "I AIR_NORMAL", "Q SPARE1", "Q XYZ", "W S1_LS_GATE_ADV"});
  CHECK(paired.of(name::Account::operator_panel) == "START_PB");
  CHECK(paired.of(name::Account::constant) == "AIR_NORMAL");
  CHECK_FALSE(paired.pairing.constant_on[1]);
  CHECK(paired.of(name::Account::ignored) == "SPARE1");
  CHECK(paired.of(name::Account::no_rule) == "XYZ");
  CHECK(paired.of(name::Account::numeric) == "S1_LS_GATE_ADV");
}

TEST_CASE("Two devices of one path are reported") {
  name::Naming naming = naming_of("{process}-{device}-{task}");
  naming.separators = "-";
  const Paired paired(naming, {"Q A_B-C-ADV", "I A_B-C-ADV", "Q A-B_C-ADV", "I A-B_C-ADV"});
  REQUIRE(paired.pairing.remarks.size() == 1);
  CHECK(paired.pairing.remarks[0].kind == Remark::Kind::path_ambiguous);
  CHECK(paired.pairing.remarks[0].input == 2);
  CHECK(paired.pairing.remarks[0].other == 0);
}

}  // namespace
}  // namespace symplant::pairing

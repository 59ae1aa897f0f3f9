// The reference derives what the model derives: lists and descriptions of every rule of the page.
#include "bench.hpp"

namespace symplant::test {
namespace {

std::string difference(const std::vector<std::string>& names, const Said& said = {}) {
  const Analysed analysed = analyse_described(bits(names), said.description);
  for (const description::DescriptionFault& fault : analysed.evidence().faults) FAIL(fault.message);
  return reference::Plant(analysed.model()).difference_from_model();
}

TEST_CASE("Lists without a description give equal derivations") {
  const std::vector<std::vector<std::string>> lists = {
      {"L_P_A_O_P1", "L_P_A_O_P2", "L_P_A_I_P1", "L_P_A_I_P2"},
      {"L_P_A_O_RUN", "L_P_A_I_RUN"},
      {"L_P_A_I_ON"},
      {"L_P_A_I_ON*"},
      {"L_P_A_O_RUN2", "L_P_A_I_RUN2"},
      {"L_P_A_O_ADV", "L_P_A_I_ADV", "L_P_A_I_RET"},
      {"L_P_A_O_ADV", "L_P_A_I_adv", "L_P_A_I_RET", "l_p_a_I_Ret"},
      {"L_P_A_O_CLAMP", "L_P_A_I_CLAMPED"},
      {"L_P_A_O_RUN2", "L_P_A_I_RUN2", "L_P_A_I_IDLE1"},
      {"L_P_A_O_RUN12", "L_P_A_I_RUN2", "L_P_A_I_IDLE007", "L_P_A_I_Q12", "L_P_A_I_Z9", "L_P_A_I_LOOSE"},
      {"L_P_A_I_B2", "L_P_A_I_A2", "L_P_A_O_C1"},
      {"L_P_A_I_P1*", "L_P_A_I_P2*", "L_P_A_O_P2"},
      {"L_P_A_I_P1", "L_P_A_I_P2*", "L_P_A_O_P2", "L_P_B_O_GREEN"},
  };
  for (const auto& names : lists) {
    INFO(names.front() << " and " << names.size() - 1 << " more");
    CHECK(difference(names) == "");
  }
}

TEST_CASE("The description overrides what is derived, by the rules of replacement") {
  const std::vector<std::string> names = {"L_P_A_O_RUN2",  "L_P_A_O_HOME", "L_P_A_I_RUN2",
                                          "L_P_A_I_IDLE1", "L_P_A_I_BUSY", "L_P_A_I_DONE3"};
  Said said;
  description::DeviceDescription& device = said.device("l_p_a");
  device.states = {"DOCK", "PARK4"};
  device.transitions = {transition("*", "IDLE1", "HOME"), transition("IDLE1", "DOCK", "RUN2"),
                        automatic("RUN2", "DONE3", 5), transition("DOCK", "RUN2")};
  device.transitions[0].when = "L_P_A.moving";
  device.outputs = {{"RUN2", {{"BUSY", true}}, {{"BUSY", false}}}};
  CHECK(difference(names, said) == "");
  device.only = true;
  CHECK(difference(names, said) == "");
  device.actuation = tables::Actuation::spring;
  CHECK(difference(names, said) == "");
  device.rest = "DOCK";
  device.initial = "DONE3";
  device.transitions.push_back(transition("RUN2", "DOCK"));
  CHECK(difference(names, said) == "");
  said.description.defaults = {7, 9, tables::Actuation::held};
  device.only = false;
  CHECK(difference(names, said) == "");
}

TEST_CASE("A model with another derivation is detected") {
  Analysed analysed = analyse_rows(bits({"L_P_A_O_P1", "L_P_A_O_P2", "L_P_A_I_P1", "L_P_A_I_P2"}));
  REQUIRE(reference::Plant(analysed.model()).difference_from_model() == "");
  model::Unit& unit = analysed.derived->plant.units[0];
  const model::Unit as_it_was = unit;
  unit.initial = 1;
  CHECK(reference::Plant(analysed.model()).difference_from_model() == "L_P_A: initial: reference `0`, model `1`");
  unit = as_it_was;
  unit.transitions[1].takes = description::Duration::fixed(3);
  CHECK(reference::Plant(analysed.model()).difference_from_model() != "");
  unit = as_it_was;
  std::swap(unit.states[0], unit.states[1]);
  CHECK(reference::Plant(analysed.model()).difference_from_model() != "");
  unit = as_it_was;
  unit.actuation = tables::Actuation::held;
  CHECK(reference::Plant(analysed.model()).difference_from_model() != "");
}

}  // namespace
}  // namespace symplant::test

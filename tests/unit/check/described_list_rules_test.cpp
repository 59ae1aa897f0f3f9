// The list rules on plants with a description.
#include "check_support.hpp"

namespace symplant::test {
namespace {

std::string undriven(const std::vector<std::string>& names, const description::DeviceDescription& d) {
  return reported(analyse_described(bits(names), describing({d})), "event-not-driven");
}

TEST_CASE("An event is not driven without an automatic transition, output or behavior") {
  const std::vector<std::string> names{"L_P_D_I_P1", "L_P_D_I_P2", "L_P_D_I_P3"};
  description::DeviceDescription d = device();
  CHECK(undriven(names, d) ==
        ": nothing drives `L_P_D_I_P1` and 2 more events of `L_P_D`; write Initial TRUE for a "
        "contact that is on in a healthy plant");
  d.transitions = {by_itself("P1", "P2"), by_itself("P2", "P1")};
  CHECK(undriven(names, d) ==
        ": nothing drives `L_P_D_I_P3`; write Initial TRUE for a contact that is on in a healthy plant");
  d.outputs = {{"P2", {{"P3", true}}, {{"P3", false}}}};
  CHECK(undriven(names, d) == "");
  d.outputs.clear();
  d.behaviour = "MyOwn";
  CHECK(undriven(names, d) == "");
}

TEST_CASE("An event that the list or the description switches on is one that nothing needs to drive") {
  description::DeviceDescription d = device();
  CHECK(undriven({"L_P_D_I_ON"}, d) != "");
  CHECK(undriven({"L_P_D_I_ON*"}, d) == "");
  d.initial = "ON";
  CHECK(undriven({"L_P_D_I_ON"}, d) == "");
}

TEST_CASE("An operation has no missing event if another event reports the state, or the state is never entered") {
  const std::vector<std::string> names{"L_P_D_O_P1",   "L_P_D_I_P1", "L_P_D_O_P2",
                                       "L_P_D_I_BUSY", "L_P_D_O_P3", "L_P_D_I_P3"};
  description::DeviceDescription d = device();
  const auto count = [&] { return analyse_described(bits(names), describing({d})).count("operation-without-event"); };
  CHECK(count() == 1);
  d.outputs = {{"P2", {{"BUSY", true}}, {{"BUSY", false}}}};
  CHECK(count() == 0);
  d.outputs = {{"P1", {{"BUSY", true}}, {{"BUSY", false}}}};
  CHECK(count() == 1);
  d.behaviour = "MyOwn";
  CHECK(count() == 0);
  d.behaviour.clear();
  d.only = true;
  d.transitions = {transition("P1", "P3"), transition("P3", "P1")};
  CHECK(count() == 0);
}

TEST_CASE("Of several events with Initial TRUE only those of states are counted") {
  std::vector<std::string> names{"L_P_D_O_P1", "L_P_D_I_P1*", "L_P_D_O_P2", "L_P_D_I_P2*", "L_P_D_I_READY*"};
  description::DeviceDescription d = device();
  d.outputs = {{"P1", {{"READY", true}}, {}}};
  const Analysed list = analyse_described(bits(names), describing({d}));
  for (const diag::Diagnostic& finding : list.diagnostics.all()) {
    if (finding.rule->slug == "initial-ambiguous") CHECK(finding.related.size() == 1);
  }
  CHECK(list.count("initial-ambiguous") == 1);
}

TEST_CASE("A state that several could come before is not reported if the description leads to it") {
  const std::vector<std::string> names{"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B1", "L_P_D_I_B1",
                                       "L_P_D_I_C2", "L_P_D_O_D2", "L_P_D_I_D2"};
  description::DeviceDescription d = device();
  const std::string found = reported(analyse_described(bits(names), describing({d})), "event-without-operation");
  CHECK_THAT(found,
             Catch::Matchers::ContainsSubstring("`L_P_D_I_C2` reports `C2` of `L_P_D`, but no operation leads there"));
  d.transitions = {by_itself("A1", "C2")};
  CHECK(analyse_described(bits(names), describing({d})).count("event-without-operation") == 0);
}

}  // namespace
}  // namespace symplant::test

// The list rules on plants with a description.
#include "check_support.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kCylinder = {"L_P_D_O_ADV", "L_P_D_I_ADV", "L_P_D_I_RET"};

std::string inference_2(const description::DeviceDescription& d) {
  return reported(analyse_described(bits(kCylinder), describing({d})), "inferred-single-solenoid");
}

TEST_CASE("Inference 2 reports only what the description leaves open") {
  description::DeviceDescription d = device();
  CHECK(inference_2(d) ==
        ": `L_P_D` has an operation only for `ADV`: it is taken as a single solenoid that returns to `RET` "
        "(inference 2)");
  d.actuation = tables::Actuation::held;
  CHECK(inference_2(d) == ": `L_P_D` has an operation only for `ADV`: it is taken to start in `RET` (inference 2)");
  d.initial = "ADV";
  CHECK(inference_2(d) == "");
  d.actuation = tables::Actuation::spring;
  CHECK(inference_2(d) == ": `L_P_D` has an operation only for `ADV`: it is taken to rest in `RET` (inference 2)");
  d.rest = "ADV";
  CHECK(inference_2(d) == "");
  d.actuation.reset();
  CHECK(inference_2(d) ==
        ": `L_P_D` has an operation only for `ADV`: it is taken as a single solenoid that returns to `ADV` "
        "(inference 2)");
}

TEST_CASE("Inference 1 reports a spring only if the device is one") {
  const auto subject = [](const description::DeviceDescription& d) {
    return reported(analyse_described(bits({"L_P_D_O_RUN", "L_P_D_I_RUN"}), describing({d})), "inferred-rest-state");
  };
  description::DeviceDescription d = device();
  CHECK(subject(d) ==
        ": `L_P_D` has the one task `RUN`: it gets the rest state `NOT_RUN` and returns to it like a spring "
        "(inference 1)");
  d.actuation = tables::Actuation::held;
  CHECK(subject(d) ==
        ": `L_P_D` has the one task `RUN`: it gets the rest state `NOT_RUN`, in which it starts (inference 1)");
  d.initial = "RUN";
  CHECK(subject(d) == ": `L_P_D` has the one task `RUN`: it gets the rest state `NOT_RUN` (inference 1)");
}

std::string undriven(const std::vector<std::string>& names, const description::DeviceDescription& d) {
  return reported(analyse_described(bits(names), describing({d})), "event-not-driven");
}

TEST_CASE("An event is not driven without an automatic transition, output or behavior") {
  const std::vector<std::string> names{"L_P_D_I_P1", "L_P_D_I_P2", "L_P_D_I_P3"};
  description::DeviceDescription d = device();
  CHECK(undriven(names, d) ==
        ": `L_P_D_I_P1` and 2 more of `L_P_D`: no device drives them, since the device has no operation; they keep "
        "their initial values");
  d.transitions = {by_itself("P1", "P2"), by_itself("P2", "P1")};
  CHECK(undriven(names, d) ==
        ": `L_P_D_I_P3`: no device drives it, since no state that the device reaches switches it; it stays off; if it "
        "is a contact that is on in a healthy plant, write Initial TRUE");
  d.outputs = {{"P2", {{"P3", true}}, {{"P3", false}}}};
  CHECK(undriven(names, d) == "");
  d.outputs.clear();
  d.behaviour = "MyOwn";
  CHECK(undriven(names, d) == "");
}

TEST_CASE("An event that no device drives starts as the description says") {
  description::DeviceDescription d = device();
  d.initial = "ON";
  CHECK_THAT(
      undriven({"L_P_D_I_ON"}, d),
      Catch::StartsWith(": `L_P_D_I_ON`: no device drives it, since the device has no operation; it stays on, as the "
                        "description says [: follows from this (inferred-rest-state): "));
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

TEST_CASE("The description's `initial` fixes a start by the order of rows") {
  const auto text = [](std::vector<description::DeviceDescription> devices) {
    return reported(analyse_described(bits({"L_P_D_O_ADV", "L_P_D_I_ADV", "L_P_D_O_RET", "L_P_D_I_RET"}),
                                      describing(std::move(devices))),
                    "initial-by-row-order");
  };
  CHECK(
      text({}) ==
      ": `L_P_D` starts in `ADV`, only because its row comes first: write Initial TRUE for the event that is on then");
  CHECK(text({device()}) ==
        "/devices/L_P_D: `L_P_D` starts in `ADV`, only because its row comes first: give `initial` in plant.json");
}

TEST_CASE("Devices that start by the order of rows are one finding if they are more than a third of a list") {
  const auto findings = [](int by_order, int with_initial) {
    std::vector<std::string> names;
    for (int i = 0; i < by_order + with_initial; ++i) {
      const std::string device = "L_P_D" + std::string(1, static_cast<char>('A' + i));
      for (const char* task : {"_O_ADV", "_I_ADV", "_O_RET", "_I_RET"}) names.push_back(device + task);
      if (i >= by_order) names.back() += '*';
    }
    return analyse_rows(bits(names));
  };
  const auto count = [&](int by_order, int with_initial) {
    return findings(by_order, with_initial).count("initial-by-row-order");
  };
  CHECK(count(3, 0) == 3);
  CHECK(count(4, 8) == 4);
  CHECK(count(4, 7) == 1);
  CHECK(reported(findings(5, 2), "initial-by-row-order") ==
        ": 5 of 7 devices of `symbols.csv` start in a state only because its row comes first, such as "
        "`L_P_DA` in `ADV`, "
        "`L_P_DB` in `ADV`, `L_P_DC` in `ADV`: write Initial TRUE for the event that is on then");
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

TEST_CASE("A sequence is not ambiguous if the description leads to the state") {
  const std::vector<std::string> names{"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B1", "L_P_D_I_B1",
                                       "L_P_D_I_C2", "L_P_D_O_D2", "L_P_D_I_D2"};
  description::DeviceDescription d = device();
  CHECK(analyse_described(bits(names), describing({d})).count("sequence-ambiguous") == 1);
  d.transitions = {by_itself("A1", "C2")};
  CHECK(analyse_described(bits(names), describing({d})).count("sequence-ambiguous") == 0);
}

}  // namespace
}  // namespace symplant::test

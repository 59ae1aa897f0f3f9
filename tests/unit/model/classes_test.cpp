// Class names from a description, and the devices that one behavior can serve.
#include "description_support.hpp"

namespace symplant::test {
namespace {

const std::vector<std::string> kTwins = {"L_P_D_O_A1", "L_P_D_I_A1", "L_P_D_O_B2", "L_P_D_I_B2",
                                         "L_P_E_O_A1", "L_P_E_I_A1", "L_P_E_O_B2", "L_P_E_I_B2"};

DeviceDescription behaving(std::string path, std::string behaviour) {
  DeviceDescription d = device(std::move(path));
  d.behaviour = std::move(behaviour);
  return d;
}

/// The faults of two equal devices, the second of which `alter` changes.
template <class Alter>
std::string faults_of_twins(Alter&& alter) {
  DeviceDescription first = behaving("L_P_D", "Mine");
  DeviceDescription second = behaving("L_P_E", "Mine");
  alter(second);
  return faults(described(kTwins, {first, second}));
}

TEST_CASE("One behavior may serve many equal devices") {
  CHECK(faults_of_twins([](DeviceDescription&) {}) == "");
  CHECK(faults_of_twins([](DeviceDescription& d) {
          d.initial = "B2";
          d.transitions = {taking(transition("A1", "B2"), 7)};
          d.outputs = {{"A1", {{"B2", true}}, {}}};
        }) == "");
}

TEST_CASE("Invalid class names are faults, with a valid suggestion") {
  for (const auto& [name, legal] : std::vector<std::pair<std::string, std::string>>{{"class", "class_"},
                                                                                    {"my stopper", "my_u0020_stopper"},
                                                                                    {"2nd", "n2nd"},
                                                                                    {"errno", "errno_"},
                                                                                    {"a__b", "a_u005F_b"}}) {
    DeviceDescription d = device();
    d.type = name;
    CHECK(faults(described(kTwins, {d})) ==
          "/devices/L_P_D/type: `" + name + "` is not a valid C++ class name; write `" + legal + "`, for example");
    CHECK(faults(described(kTwins, {behaving("L_P_D", name)})) ==
          "/devices/L_P_D/behaviour: `" + name + "` is not a valid C++ class name; write `" + legal + "`, for example");
  }
}

TEST_CASE("Names that generated code uses are faults") {
  for (const std::string name : {"Plant", "Device", "State", "View", "kI", "behaviours"}) {
    DeviceDescription d = device();
    d.type = name;
    CHECK(faults(described(kTwins, {d})) ==
          "/devices/L_P_D/type: `" + name + "` is a name that generated code uses itself; choose another");
  }
}

TEST_CASE("A behavior named like a type, or like another behavior except for case, is a fault") {
  DeviceDescription typed = device("L_P_E");
  typed.type = "Mine";
  CHECK(faults(described(kTwins, {behaving("L_P_D", "Mine"), typed})) ==
        "/devices/L_P_D/behaviour: `Mine` is also the `type` of `L_P_E`; choose another name for the derived class");
  CHECK(faults(described(kTwins, {behaving("L_P_D", "Mine"), behaving("L_P_E", "mine")})) ==
        "/devices/L_P_E/behaviour: `mine` and `Mine` differ only in case; write them the same or choose another name");
}

TEST_CASE("A behavior of devices with different structure is a fault that names the difference") {
  const std::string begin = "/devices/L_P_E/behaviour: `Mine` is also the `behaviour` of `L_P_D`, which has other ";
  const std::string end = ", or the same in another order; choose another name for one of them";
  CHECK(faults_of_twins([](DeviceDescription& d) { d.type = "Other"; }) == begin + "`type`" + end);
  CHECK(faults_of_twins([](DeviceDescription& d) { d.states = {"C3"}; }) == begin + "states" + end);
  CHECK(faults_of_twins([](DeviceDescription& d) { d.inputs = {{"part", "L_P_D.A1"}}; }) == begin + "`inputs`" + end);
  const auto list = [&](const std::string& more) {
    std::vector<std::string> names = kTwins;
    names.push_back(more);
    return faults(described(names, {behaving("L_P_D", "Mine"), behaving("L_P_E", "Mine")}));
  };
  CHECK(list("L_P_E_O_C3") == begin + "operations" + end);
  CHECK(list("L_P_E_I_C3") == begin + "events" + end);
  std::vector<Row> rows = bits(kTwins);
  rows.push_back({"L_P_E_I_LEVEL", "", "INT", "0", "%IW1"});
  CHECK(faults(analyse_described(rows, describing({behaving("L_P_D", "Mine"), behaving("L_P_E", "Mine")}))) ==
        begin + "numeric symbols" + end);
}

TEST_CASE("Inputs have unique names, ignoring case") {
  DeviceDescription d = behaving("L_P_D", "Mine");
  d.inputs = {{"part", "L_P_E.A1"}, {"Part", "L_P_E.B2"}, {"", "L_P_E.B2"}};
  CHECK(faults(described(kTwins, {d})) ==
        "/devices/L_P_D/inputs/Part: `Part` already names another input; choose another name\n"
        "/devices/L_P_D/inputs/: this input has no name; give it one");
}

}  // namespace
}  // namespace symplant::test

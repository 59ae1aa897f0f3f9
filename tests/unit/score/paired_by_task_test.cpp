// Tests of pairs under the built-in naming rule, sentence by sentence of docs/checking.md, "The score".
#include "score/paired_by_task.hpp"

#include <string>
#include <vector>

#include "unit/model/description_support.hpp"

namespace symplant::test {
namespace {

/// The tasks of paired symbols with their directions, in list order: "O_ADV I_ADV".
std::string paired(const Analysed& analysed) {
  std::string text;
  const std::vector<bool> values = score::paired_by_task(analysed.model());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i]) continue;
    const std::string_view name = analysed.model().symbols[i].name();
    text.append(text.empty() ? "" : " ").append(name.substr(std::string_view("L_P_D_").size()));
  }
  return text;
}

std::string paired(const std::vector<std::string>& tasks, std::vector<DeviceDescription> devices = {}) {
  std::vector<std::string> names;
  for (const std::string& task : tasks) names.push_back("L_P_D_" + task);
  return paired(described(names, std::move(devices)));
}

TEST_CASE("An operation and an event of one task are paired, other tasks of the device are not") {
  CHECK(paired({"O_RUN", "I_RUN", "O_LAMP", "I_BUTTON"}) == "O_RUN I_RUN");
}

TEST_CASE("A device with many symbols and few common tasks is not wholly paired") {
  std::vector<std::string> tasks;
  for (int i = 0; i < 34; ++i) tasks.push_back("O_" + std::string(i < 5 ? "BOTH" : "OUT") + std::to_string(i) + "X");
  for (int i = 0; i < 29; ++i) tasks.push_back("I_" + std::string(i < 5 ? "BOTH" : "IN") + std::to_string(i) + "X");
  const Analysed list = described(
      [&] {
        std::vector<std::string> names;
        for (const std::string& task : tasks) names.push_back("L_P_D_" + task);
        return names;
      }(),
      {});
  const std::vector<bool> values = score::paired_by_task(list.model());
  CHECK(list.model().units.size() == 1);
  CHECK(std::count(values.begin(), values.end(), true) == 10);
}

TEST_CASE("The sensor of the position to which a single solenoid returns is paired") {
  CHECK(paired({"O_ADV", "I_ADV", "I_RET"}) == "O_ADV I_ADV I_RET");
  CHECK(paired({"O_RUN", "I_RUN", "I_STOPPED"}) == "O_RUN I_RUN I_STOPPED");
}

TEST_CASE("An operation pairs with the sensor of the other end of its motion, which it leaves") {
  CHECK(paired({"O_ADV", "I_RET", "I_OTHER"}) == "O_ADV I_RET");
  CHECK(paired({"O_OPEN", "O_CLOSE", "I_OPEN"}) == "O_OPEN O_CLOSE I_OPEN");
}

TEST_CASE("Of several motions only those of one number pair with the other end") {
  CHECK(paired({"O_ADV1", "O_OUT1", "O_ADV2", "I_RET2", "I_IN2", "I_RET3"}) == "O_ADV2 I_RET2");
}

TEST_CASE("What follows by itself in a sequence is paired with the operation before it") {
  CHECK(paired({"I_HOME1", "O_JOB2", "I_JOB2", "I_DONE3"}) == "I_HOME1 O_JOB2 I_JOB2 I_DONE3");
  CHECK(paired({"I_HOME1", "O_JOB2"}) == "I_HOME1 O_JOB2");
}

TEST_CASE("A given transition pairs its operation with the events of its two states") {
  DeviceDescription d = device();
  d.transitions = {transition("HOME", "WORK", "GO")};
  CHECK(paired({"O_GO", "I_HOME", "I_WORK", "O_LAMP", "I_OTHER"}, {d}) == "O_GO I_HOME I_WORK");
  d.transitions = {transition("*", "WORK", "GO")};
  CHECK(paired({"O_GO", "I_HOME", "I_WORK", "I_OTHER"}, {d}) == "O_GO I_WORK");
}

TEST_CASE("The operation of a condition is paired with the event that its transition moves") {
  DeviceDescription d = device();
  d.transitions = {automatic("HOME", "WORK", "L_P_E_O_GO")};
  const Analysed list = described({"L_P_D_I_HOME", "L_P_D_I_WORK", "L_P_E_O_GO", "L_P_E_O_STOP"}, {d});
  CHECK(faults(list).empty());
  CHECK(paired(list) == "I_HOME I_WORK O_GO");
}

TEST_CASE("Events that outputs switch are paired with the operation of the state") {
  DeviceDescription d = device();
  d.outputs.push_back({"RUN", {{"BUSY", true}}, {{"BUSY", false}}});
  CHECK(paired({"O_RUN", "I_BUSY", "I_OTHER"}, {d}) == "O_RUN I_BUSY");
}

TEST_CASE("A custom behavior pairs all symbols of its device") {
  DeviceDescription d = device();
  d.behaviour = "Custom";
  CHECK(paired({"O_A", "I_B", "I_C"}, {d}) == "O_A I_B I_C");
}

TEST_CASE("If only given transitions apply, equal tasks alone do not pair") {
  DeviceDescription d = device();
  d.only = true;
  d.given.set(static_cast<std::size_t>(description::DeviceKey::only));
  d.transitions = {automatic("A", "B")};
  CHECK(paired({"O_A", "I_A", "O_B", "I_B"}, {d}) == "I_A I_B");
}

}  // namespace
}  // namespace symplant::test

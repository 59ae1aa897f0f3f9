// `sequence`: which numbered states derived transitions join.
#include "description_support.hpp"

namespace symplant::test {
namespace {

using description::Sequence;

/// Each with operation and event.
std::vector<std::string> states(const std::vector<std::string>& tasks) {
  std::vector<std::string> names;
  for (const std::string& task : tasks) {
    names.push_back("L_P_D_O_" + task);
    names.push_back("L_P_D_I_" + task);
  }
  return names;
}

DeviceDescription in_sequence(Sequence sequence) {
  DeviceDescription d = device();
  d.sequence = sequence;
  return d;
}

std::string joined(const std::vector<std::string>& tasks, Sequence sequence) {
  const Analysed list = described(states(tasks), {in_sequence(sequence)});
  CHECK(faults(list) == "");
  std::string text;
  for (const model::Transition& t : unit_of(list).transitions) {
    const auto& s = unit_of(list).states;
    text += (text.empty() ? "" : " ") + s[t.from].name + ">" + s[t.to].name;
  }
  return text;
}

TEST_CASE("`free` joins all states") {
  CHECK(joined({"A1", "B2", "C3"}, Sequence::free) == "B2>A1 C3>A1 A1>B2 C3>B2 A1>C3 B2>C3");
}

TEST_CASE("`neighbours` joins numbers that are next to each other among those of the device") {
  CHECK(joined({"A1", "B2", "C3"}, Sequence::neighbours) == "B2>A1 A1>B2 C3>B2 B2>C3");
  CHECK(joined({"A1", "B5", "C30"}, Sequence::neighbours) == "B5>A1 A1>B5 C30>B5 B5>C30");
  CHECK(joined({"A1", "B2"}, Sequence::neighbours) == "B2>A1 A1>B2");
}

TEST_CASE("`cycle` leads to the next higher number, and from the highest to the lowest") {
  CHECK(joined({"A1", "B2", "C3"}, Sequence::cycle) == "C3>A1 A1>B2 B2>C3");
  CHECK(joined({"A9", "B100", "C20"}, Sequence::cycle) == "B100>A9 A9>C20 C20>B100");
  CHECK(joined({"A1", "B2"}, Sequence::cycle) == "B2>A1 A1>B2");
}

TEST_CASE("States of equal number join neither as neighbors nor in a cycle, unless there is no other number") {
  CHECK(joined({"A1", "B1", "C2"}, Sequence::neighbours) == "C2>A1 C2>B1 A1>C2 B1>C2");
  CHECK(joined({"A1", "B01", "C2"}, Sequence::cycle) == "C2>A1 C2>B01 A1>C2 B01>C2");
  CHECK(joined({"A1", "B1"}, Sequence::neighbours).empty());
  CHECK(joined({"A1", "B1"}, Sequence::cycle) == "B1>A1 A1>B1");
}

TEST_CASE("States without a number join freely") {
  CHECK(joined({"A1", "B2", "C3", "HOME"}, Sequence::cycle) ==
        "C3>A1 HOME>A1 A1>B2 HOME>B2 B2>C3 HOME>C3 A1>HOME B2>HOME C3>HOME");
}

TEST_CASE("Added states count by their digits") {
  DeviceDescription d = in_sequence(Sequence::neighbours);
  d.states = {"MID2"};
  const Analysed list = described(states({"A1", "C3"}), {d});
  CHECK(faults(list) == "");
  CHECK(list.model().units.front().transitions.size() == 2);
}

TEST_CASE("`sequence` does not touch given transitions") {
  DeviceDescription d = in_sequence(Sequence::cycle);
  d.transitions = {transition("C3", "B2"), automatic("B2", "A1")};
  const Analysed list = described(states({"A1", "B2", "C3"}), {d});
  CHECK(faults(list) == "");
  CHECK(origins(unit_of(list)) == "ggddd");
}

TEST_CASE("A device without numbered states is a fault under its exact name only") {
  const std::vector<std::string> names = states({"RET", "ADV"});
  for (const Sequence sequence : {Sequence::neighbours, Sequence::cycle}) {
    CHECK(faults(described(names, {in_sequence(sequence)})) ==
          "/devices/L_P_D/sequence: `L_P_D` has no numbered states; remove `sequence`");
    DeviceDescription pattern = in_sequence(sequence);
    pattern.path = "L_*";
    CHECK(faults(described(names, {pattern})) == "");
    description::Description defaults;
    defaults.defaults.sequence = sequence;
    CHECK(faults(analyse_described(bits(names), std::move(defaults))) == "");
  }
  CHECK(faults(described(names, {in_sequence(Sequence::free)})) == "");
}

TEST_CASE("A device's `sequence` overrides the default one") {
  description::Description description = describing({in_sequence(Sequence::free)});
  description.defaults.sequence = Sequence::cycle;
  const Analysed list = analyse_described(bits(states({"A1", "B2", "C3"})), std::move(description));
  CHECK(unit_of(list).transitions.size() == 6);
}

TEST_CASE("A default `sequence` is for all devices") {
  description::Description description;
  description.defaults.sequence = Sequence::cycle;
  const Analysed list = analyse_described(bits(states({"A1", "B2", "C3"})), std::move(description));
  CHECK(unit_of(list).transitions.size() == 3);
}

}  // namespace
}  // namespace symplant::test

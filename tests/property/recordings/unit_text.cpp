// Units for people.
#include "property/recordings/unit_text.hpp"

#include <array>

namespace symplant::property {
namespace {

using tables::kNone;
using tables::Time;

std::string milliseconds(Time time) {
  return std::to_string(time / tables::kMillisecond) + "." + std::to_string(time % tables::kMillisecond / 1000);
}

std::string duration_text(const description::Duration& duration) {
  const bool random = duration.kind == description::Duration::Kind::uniform;
  return milliseconds(duration.a) + (random ? ".." + milliseconds(duration.b) : "");
}

/// The symbols that a condition reads, and the states.
std::string condition_text(const model::PlantModel& plant, const condition::Tree& tree) {
  using Kind = condition::Tree::Kind;
  if (tree.kind == Kind::constant) return tree.value ? "true" : "false";
  if (tree.kind == Kind::atom) {
    const condition::Atom& atom = tree.atom;
    if (atom.kind == condition::Atom::Kind::settled) {
      return std::string(plant.units[atom.of].path) + "." + plant.units[atom.of].states[atom.state].name;
    }
    if (atom.kind == condition::Atom::Kind::moving) return std::string(plant.units[atom.of].path) + ".moving";
    if (atom.kind == condition::Atom::Kind::bit || atom.kind == condition::Atom::Kind::number) {
      return "'" + std::string(plant.symbols[atom.of].name()) + "'";
    }
    return "?";
  }
  std::string text = tree.kind == Kind::negation ? "not" : tree.kind == Kind::all ? "and" : "or";
  text += "(";
  for (const condition::Tree& child : tree.children) text += condition_text(plant, child) + " ";
  return text + ")";
}

}  // namespace

std::string unit_text(const model::PlantModel& plant, std::uint32_t u, const recording::Recording& recording,
                      Time begin, Time end) {
  static constexpr std::array<const char*, 4> kActuations{"latched", "bistable", "held", "spring"};
  const model::Unit& unit = plant.units[u];
  const auto symbol = [&](std::uint32_t s) {
    return std::string(plant.symbols[s].name()) + (plant.symbols[s].inverted ? "(inverted)" : "");
  };
  std::string text = std::string(unit.path) + " " + kActuations[static_cast<std::size_t>(unit.actuation)];
  if (unit.rest != kNone) text += " rest " + unit.states[unit.rest].name;
  text += "\n";
  for (std::size_t s = 0; s < unit.states.size(); ++s) {
    const model::State& state = unit.states[s];
    text += "  state " + state.name;
    if (state.operation != kNone) text += " by " + symbol(unit.operations[state.operation]);
    if (state.event != kNone) text += " shows " + symbol(unit.events[state.event]);
    if (!unit.outputs.empty()) {
      for (const auto& [event, on] : unit.outputs[s].enter) text += (on ? " +" : " -") + symbol(unit.events[event]);
      for (const auto& [event, on] : unit.outputs[s].leave) text += (on ? " l+" : " l-") + symbol(unit.events[event]);
    }
    text += "\n";
  }
  for (std::size_t i = 0; i < unit.transitions.size(); ++i) {
    const model::Transition& t = unit.transitions[i];
    text += "  #" + std::to_string(i) + " " + unit.states[t.from].name + "->" + unit.states[t.to].name;
    text += t.spring_return ? " return" : t.on == kNone ? " automatic" : " on " + symbol(unit.operations[t.on]);
    text += " after " + duration_text(t.after) + " takes " + duration_text(t.takes) + (t.once ? " once" : "");
    if (t.when != kNone) text += " when " + condition_text(plant, unit.conditions[t.when]);
    if (t.during != kNone) text += " while " + condition_text(plant, unit.conditions[t.during]);
    text += "\n";
  }
  for (const model::Unit& other : plant.units) {
    for (std::size_t s = 0; s < other.disables.size(); ++s) {
      for (const std::uint32_t disabled : other.disables[s]) {
        if (disabled == u) text += "  disabled by " + std::string(other.path) + "." + other.states[s].name + "\n";
      }
    }
  }
  // Only what the text above names.
  const auto is_named = [&, head = text](const std::string& name) {
    const std::size_t task = std::min(name.find("_I_"), name.find("_O_"));
    return head.find(name) != std::string::npos || head.find(name.substr(0, task) + ".") != std::string::npos;
  };
  std::vector<std::size_t> next(recording.series.size(), 0);
  for (const std::uint32_t series : recording.order) {
    const recording::Series::Change& change = recording.series[series].changes[next[series]++];
    if (change.time < begin || change.time > end || !is_named(recording.series[series].name)) continue;
    text += "  " + milliseconds(change.time) + " " + recording.series[series].name + " " +
            std::to_string(static_cast<long>(change.value)) + "\n";
  }
  return text;
}

}  // namespace symplant::property

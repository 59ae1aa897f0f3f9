// State charts in words.
#include "view/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "elements/requirement/words.hpp"
#include "model/condition_text.hpp"
#include "text/utf8.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

using model::kNone;

constexpr std::size_t kLineColumns = 26;   // of a label
constexpr std::size_t kLeastForEvery = 4;  // states

/// Packs the parts of a label into few lines.
std::vector<std::string> packed(const std::vector<std::string>& parts) {
  std::vector<std::string> lines;
  for (const std::string& part : parts) {
    if (part.empty()) continue;
    if (!lines.empty() && text::count_code_points(lines.back()) + 2 + text::count_code_points(part) <= kLineColumns) {
      lines.back().append(", ").append(part);
    } else {
      lines.push_back(part);
    }
  }
  return lines;
}

std::vector<std::string> label_of(const model::Transition& t, const model::Unit& unit, const model::PlantModel& plant,
                                  Conditions conditions) {
  const TransitionText transition = transition_text(t, unit, plant);
  const auto bracketed = [&](std::string_view before, const std::string& condition, std::uint32_t index) {
    if (condition.empty()) return std::string();
    const bool in_words =
        conditions == Conditions::in_words && text::count_code_points(condition) + before.size() + 2 <= kLineColumns;
    return in_words ? fmt::format("{}[{}]", before, condition) : fmt::format("{}[c{}]", before, index + 1);
  };
  const std::string when = bracketed("", transition.when, t.when);
  const std::string during = bracketed("while ", transition.during, t.during);
  const std::string origin(t.origin == model::Origin::derived ? "" : origin_text(t.origin));
  return packed({transition.on, when, transition.after, transition.takes, during, transition.numbers, origin});
}

std::string joined(const std::vector<std::pair<std::uint32_t, bool>>& events, const model::Unit& unit,
                   const model::PlantModel& plant) {
  std::string text;
  for (const auto& [event, on] : events) {
    text.append(text.empty() ? "" : ", ").append(event_text(plant, unit, event)).append(on ? " on" : " off");
  }
  return text;
}

std::string signal_text(const model::Symbol& symbol, const model::PlantModel& plant) {
  std::string address(symbol.row->vendor_address);
  if (!symbol.row->iec_address.empty()) address.append(address.empty() ? "" : " ").append(symbol.row->iec_address);
  return fmt::format("{}  {}  {}:{}{}", symbol.name(), address.empty() ? "no address" : address,
                     plant.list_of(symbol).name(), symbol.row->line, symbol.inverted ? "  inverted" : "");
}

void add_relations(std::vector<std::string>& facts, std::uint32_t index, const model::PlantModel& plant,
                   const CrossReferences& references) {
  const model::Unit& unit = plant.units[index];
  for (std::size_t s = 0; s < unit.disables.size(); ++s) {
    for (const std::uint32_t other : unit.disables[s]) {
      facts.push_back(fmt::format("{} disables {}", unit.states[s].name, plant.units[other].path));
    }
  }
  for (const Disabler& by : references.disabled_by[index]) {
    facts.push_back(
        fmt::format("disabled by {}.{}", plant.units[by.unit].path, plant.units[by.unit].states[by.state].name));
  }
  if (unit.has_behaviour()) facts.push_back("behaviour " + unit.described->behaviour);
  for (std::size_t i = unit.first_input; i < unit.conditions.size(); ++i) {
    facts.push_back(fmt::format("input {}: {}", unit.input_names[i - unit.first_input],
                                model::condition_text(unit.conditions[i], plant)));
  }
  for (const std::uint32_t value : unit.values) facts.push_back("value " + signal_text(plant.symbols[value], plant));
  for (const std::uint32_t requirement : references.requirements[index]) {
    const model::Requirement& required = plant.requirements[requirement];
    facts.push_back("required: " + required.name + ": " + requirement_text(required, plant));
  }
}

}  // namespace

Chart chart_of(const model::Unit& unit, const model::PlantModel& plant, Conditions conditions) {
  Chart chart;
  for (const model::State& state : unit.states) {
    std::string symbols;
    if (state.operation != kNone) symbols = operation_text(plant, unit, state.operation);
    if (state.event != kNone) symbols.append(symbols.empty() ? "" : ", ").append(event_text(plant, unit, state.event));
    chart.states.push_back({state.name, std::move(symbols)});
  }

  // For each target state: its different labels in order, each with the source states.
  using Sources = std::vector<std::uint32_t>;
  std::vector<std::map<std::vector<std::string>, Sources>> routes(unit.states.size());
  std::vector<std::vector<std::vector<std::string>>> order(unit.states.size());
  std::vector<model::Transition> transitions = unit.transitions;
  for (const model::Transition& transition : spring_returns(unit)) transitions.push_back(transition);
  for (const model::Transition& t : transitions) {
    std::vector<std::string> label = label_of(t, unit, plant, conditions);
    const auto [transition, added] = routes[t.to].try_emplace(label);
    transition->second.push_back(t.from);
    if (added) order[t.to].push_back(std::move(label));
  }

  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> positions;  // target, source -> its edge
  for (std::uint32_t to = 0; to < unit.states.size(); ++to) {
    for (const std::vector<std::string>& label : order[to]) {
      Sources sources = routes[to].at(label);
      std::sort(sources.begin(), sources.end());
      sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
      if (unit.states.size() >= kLeastForEvery && sources.size() + 1 == unit.states.size()) sources = {kEveryOther};
      for (const std::uint32_t from : sources) {
        const auto [position, added] = positions.try_emplace({to, from}, chart.edges.size());
        if (added) chart.edges.push_back({from, to, true, {}});
        ChartEdge& edge = chart.edges[position->second];
        edge.automatic = edge.automatic && label.front().starts_with("by itself");
        edge.label.insert(edge.label.end(), label.begin(), label.end());
      }
    }
  }
  std::sort(chart.edges.begin(), chart.edges.end(),
            [](const ChartEdge& a, const ChartEdge& b) { return a.to != b.to ? a.to < b.to : a.from < b.from; });
  return chart;
}

std::vector<std::string> facts_of(std::uint32_t index, const model::PlantModel& plant,
                                  const CrossReferences& references) {
  const model::Unit& unit = plant.units[index];
  std::vector<std::string> facts;
  facts.push_back(fmt::format("{}, starts in {}: {}", description::actuation_name(unit.actuation),
                              unit.states[unit.initial].name, initial_reason(unit.initial_from)));
  if (unit.actuation == tables::Actuation::spring) facts.push_back("returns to " + unit.states[unit.rest].name);
  for (const std::string_view sentence : inferences(unit)) facts.push_back("inferred: " + std::string(sentence));
  for (const std::uint32_t symbol : unit.operations) facts.push_back("I  " + signal_text(plant.symbols[symbol], plant));
  for (const std::uint32_t symbol : unit.events) facts.push_back("O  " + signal_text(plant.symbols[symbol], plant));
  for (std::size_t i = 0; i < unit.first_input; ++i) {
    facts.push_back(fmt::format("c{}: {}", i + 1, model::condition_text(unit.conditions[i], plant)));
  }
  for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
    for (const bool entering : {true, false}) {
      const std::string events = joined(switched(unit, s, entering), unit, plant);
      if (events.empty()) continue;
      facts.push_back(fmt::format("{} {}: {}", entering ? "entering" : "leaving", unit.states[s].name, events));
    }
  }
  add_relations(facts, index, plant, references);
  return facts;
}

}  // namespace symplant::view

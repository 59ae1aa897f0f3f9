// The derived models for people.
#include "app/model_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "diag/visible_text.hpp"

namespace symplant::app {
namespace {

using model::kNone;

std::string times_text(const model::Duration& time) {
  switch (time.kind) {
    case model::Duration::Kind::fixed:
      break;
    case model::Duration::Kind::uniform:
      return duration_text(time.a) + " to " + duration_text(time.b);
    case model::Duration::Kind::normal:
      return duration_text(time.a) + " (sigma " + duration_text(time.b) + ")";
  }
  return duration_text(time.a);
}

void add_side(std::string& text, char element, const std::vector<std::uint32_t>& side, const model::PlantModel& plant) {
  bool first = true;
  for (const std::uint32_t index : side) {
    const model::Symbol& symbol = plant.symbols[index];
    std::string address(symbol.written_address());
    if (!symbol.row->vendor_address.empty() && !symbol.row->iec_address.empty()) {
      address.append(" ").append(symbol.row->iec_address);
    }
    fmt::format_to(std::back_inserter(text), "  {:<10}{}  {}  {}:{}\n", first ? std::string(1, element) : "",
                   symbol.name(), address.empty() ? "no address" : diag::visible(address), plant.list_of(symbol).name(),
                   symbol.row->line);
    first = false;
  }
  if (first) fmt::format_to(std::back_inserter(text), "  {:<10}none\n", element);
}

void add_transitions(std::string& text, const model::Unit& unit, const model::PlantModel& plant) {
  for (const bool commanded : {true, false}) {
    bool first = true;
    for (const model::Transition& t : unit.transitions) {
      if ((t.on != kNone) != commanded) continue;
      const std::string label = first ? (commanded ? "d_ext" : "d_int") : "";
      const std::string& from = unit.states[t.from].name;
      const std::string& to = unit.states[t.to].name;
      if (commanded) {
        fmt::format_to(std::back_inserter(text), "  {:<10}({}, O_{}) -> {}, takes {}\n", label, from,
                       plant.symbols[unit.operations[t.on]].reading.task, to, times_text(t.takes));
      } else {
        fmt::format_to(std::back_inserter(text), "  {:<10}({}) -> {}, after {}\n", label, from, to,
                       times_text(t.after));
      }
      first = false;
    }
    if (first) fmt::format_to(std::back_inserter(text), "  {:<10}none\n", commanded ? "d_ext" : "d_int");
  }
}

void add_unit(std::string& text, const model::Unit& unit, const model::PlantModel& plant) {
  fmt::format_to(std::back_inserter(text), "{}: {}, starts in {}", unit.path, model::actuation_name(unit.actuation),
                 unit.states[unit.initial].name);
  if (unit.actuation == core::Actuation::spring) {
    fmt::format_to(std::back_inserter(text), ", returns to {} in {}", unit.states[unit.rest].name,
                   duration_text(unit.travel));
  }
  text += "\n";
  add_side(text, 'I', unit.operations, plant);
  add_side(text, 'O', unit.events, plant);
  std::string states;
  for (const model::State& state : unit.states) states.append(states.empty() ? "" : ", ").append(state.name);
  fmt::format_to(std::back_inserter(text), "  {:<10}{}\n", "S", states);
  add_transitions(text, unit, plant);
  std::string lambda;
  for (const model::State& state : unit.states) {
    if (state.event == kNone) continue;
    lambda.append(lambda.empty() ? "" : ", ")
        .append(state.name)
        .append(": I_")
        .append(plant.symbols[unit.events[state.event]].reading.task);
  }
  fmt::format_to(std::back_inserter(text), "  {:<10}{}\n", "l_enter", lambda.empty() ? "nothing" : "on " + lambda);
  fmt::format_to(std::back_inserter(text), "  {:<10}{}\n", "l_leave", lambda.empty() ? "nothing" : "off " + lambda);
  fmt::format_to(std::back_inserter(text), "  {:<10}none\n\n", "l_disable");
}

}  // namespace

std::string duration_text(core::Time time) {
  if (time % core::kSecond == 0) return fmt::format("{} s", time / core::kSecond);
  if (time % core::kMillisecond == 0) return fmt::format("{} ms", time / core::kMillisecond);
  return fmt::format("{} ns", time);
}

std::string model_table(const model::PlantModel& plant, const std::vector<std::uint32_t>& units) {
  std::string text;
  for (const std::uint32_t unit : units) add_unit(text, plant.units[unit], plant);
  const auto unmodelled = std::count_if(plant.symbols.begin(), plant.symbols.end(), [](const model::Symbol& symbol) {
    return symbol.unmodelled != model::Unmodelled::modelled;
  });
  fmt::format_to(std::back_inserter(text), "{} device{}, {} I/O symbol{}, {} of them in no device\n",
                 plant.units.size(), plant.units.size() == 1 ? "" : "s", plant.symbols.size(),
                 plant.symbols.size() == 1 ? "" : "s", unmodelled);
  return text;
}

}  // namespace symplant::app

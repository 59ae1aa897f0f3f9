// The derived models as a table, for people at a terminal.
#include "view/model_table.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>

#include "diag/visible_text.hpp"
#include "elements/follow/words.hpp"
#include "elements/malfunction/words.hpp"
#include "elements/material/words.hpp"
#include "elements/requirement/words.hpp"
#include "elements/value/words.hpp"
#include "model/condition_text.hpp"
#include "view/cross_references.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

using model::kNone;

class TableWriter {
 public:
  TableWriter(const model::PlantModel& plant, base::TextSink& sink)
      : plant_(plant), references_(cross_references(plant)), text_(sink) {}

  void write(const std::vector<std::uint32_t>& units) {
    for (const std::uint32_t unit : units) add_unit(unit);
    if (!plant_.requirements.empty()) {
      line("requirements");
      for (const model::Requirement& requirement : plant_.requirements) {
        line("  " + requirement.name + ": " + requirement_text(requirement, plant_));
      }
      text_.add("\n");
    }
    if (!plant_.values.empty()) {
      line("values");
      for (const model::Value& value : plant_.values) line("  " + value.name + ": " + value_line(value, plant_));
    }
    if (!plant_.signals.empty()) {
      line("signals");
      for (const model::Signal& signal : plant_.signals) {
        line(fmt::format("  {}: {}", plant_.symbols[signal.row.symbol].name(), signal_line(signal, plant_)));
      }
    }
    if (!plant_.follows.empty()) {
      line("follow");
      for (const model::Follow& follow : plant_.follows) {
        line(fmt::format("  {}: {}", plant_.symbols[follow.symbol].name(), follow_text(follow, plant_)));
      }
      text_.add("\n");
    }
    if (const std::vector<std::string> material = material_lines(plant_); !material.empty()) {
      line("material");
      for (const std::string& each : material) line("  " + each);
      text_.add("\n");
    }
    if (!plant_.malfunctions.empty()) {
      line("malfunctions");
      for (const model::Malfunction& malfunction : plant_.malfunctions) {
        line("  " + malfunction.name + ": " + malfunction_text(malfunction, plant_));
      }
      text_.add("\n");
    }
    add_counts();
    text_.finish();
  }

 private:
  /// Adds one line, made safe to show.
  void line(const std::string& content) {
    text_.add(diag::visible(content));
    text_.add("\n");
  }

  /// Adds a row. The first row of an element starts with the element's name.
  void row(const std::string& content) {
    line(fmt::format("  {:<12}{}", element_, content));
    element_ = "";
  }
  void begin(std::string_view element) { element_ = element; }
  /// Ends an element. Writes `otherwise` if it had no rows.
  void end(std::string_view otherwise = "none") {
    if (!element_.empty()) row(std::string(otherwise));
  }

  void add_unit(std::uint32_t index) {
    const model::Unit& unit = plant_.units[index];
    std::string head = fmt::format("{}: {}, starts in {} ({})", unit.path, description::actuation_name(unit.actuation),
                                   unit.states[unit.initial].name, initial_reason(unit.initial_from));
    if (unit.actuation == tables::Actuation::spring) head += ", returns to " + unit.states[unit.rest].name;
    if (unit.overrun != tables::kNever) {
      head += ", overruns after " + duration_text(description::Duration::fixed(unit.overrun));
    }
    line(head);
    for (const std::string_view sentence : inferences(unit)) line("  inferred: " + std::string(sentence));
    add_side("I", unit.operations);
    add_side("O", unit.events);
    add_states(unit);
    add_transitions("d_ext", unit, true);
    add_transitions("d_int", unit, false);
    add_spring_returns(unit);
    add_outputs("l_enter", unit, true);
    add_outputs("l_leave", unit, false);
    add_disables(unit, references_.disabled_by[index]);
    if (unit.has_behaviour()) add_behaviour(unit);
    if (!unit.has_behaviour() && !unit.values.empty()) add_values(unit);
    if (!references_.requirements[index].empty()) {
      begin("required");
      for (const std::uint32_t requirement : references_.requirements[index])
        row(plant_.requirements[requirement].name);
    }
    text_.add("\n");
  }

  void add_side(std::string_view element, const std::vector<std::uint32_t>& side) {
    begin(element);
    for (const std::uint32_t index : side) {
      const model::Symbol& symbol = plant_.symbols[index];
      std::string address(symbol.written_address());
      if (!symbol.row->vendor_address.empty() && !symbol.row->iec_address.empty()) {
        address.append(" ").append(symbol.row->iec_address);
      }
      row(fmt::format("{}  {}  {}:{}{}", symbol.name(), address.empty() ? "no address" : address,
                      plant_.list_of(symbol).name(), symbol.row->line, symbol.inverted ? "  inverted" : ""));
    }
    end();
  }

  void add_states(const model::Unit& unit) {
    begin("S");
    for (const model::State& state : unit.states) {
      std::string symbols;
      if (state.operation != kNone) symbols = operation_text(plant_, unit, state.operation);
      if (state.event != kNone) {
        symbols.append(symbols.empty() ? "" : ", ").append(event_text(plant_, unit, state.event));
      }
      row(state.name + ": " + (symbols.empty() ? "no symbol" : symbols));
    }
  }

  void add_transitions(std::string_view element, const model::Unit& unit, bool commanded) {
    begin(element);
    for (const model::Transition& t : unit.transitions) {
      if ((t.on != kNone) != commanded) continue;
      const TransitionText transition = transition_text(t, unit, plant_);
      std::string content =
          fmt::format("({}, {}) -> {}", unit.states[t.from].name, transition.on, unit.states[t.to].name);
      if (!transition.when.empty()) content += ", when " + transition.when;
      if (!transition.after.empty()) content += ", " + transition.after;
      if (!transition.takes.empty()) content += ", " + transition.takes;
      if (!transition.during.empty()) content += ", while " + transition.during;
      if (!transition.numbers.empty()) content += ", " + transition.numbers;
      row(content + "  [" + std::string(origin_text(t.origin)) + "]");
    }
    end();
  }

  void add_spring_returns(const model::Unit& unit) {
    const auto routes = spring_returns(unit);
    if (routes.empty()) return;
    begin("spring");
    for (const model::Transition& transition : routes) {
      std::string content = fmt::format("({}) -> {}, takes {}", unit.states[transition.from].name,
                                        unit.states[transition.to].name, duration_text(transition.takes));
      if (transition.during != kNone) {
        content += ", while " + model::condition_text(unit.conditions[transition.during], plant_);
      }
      row(content);
    }
  }

  void add_outputs(std::string_view element, const model::Unit& unit, bool entering) {
    begin(element);
    for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
      std::string events;
      for (const auto& [event, on] : switched(unit, s, entering)) {
        events.append(events.empty() ? "" : ", ").append(event_text(plant_, unit, event)).append(on ? " on" : " off");
      }
      if (!events.empty()) row(unit.states[s].name + ": " + events);
    }
    end("nothing");
  }

  void add_disables(const model::Unit& unit, const std::vector<Disabler>& disabled_by) {
    begin("l_disable");
    for (std::size_t s = 0; s < unit.disables.size(); ++s) {
      std::string others;
      for (const std::uint32_t other : unit.disables[s]) {
        others.append(others.empty() ? "" : ", ").append(plant_.units[other].path);
      }
      if (!others.empty()) row(unit.states[s].name + ": " + others);
    }
    end();
    if (disabled_by.empty()) return;
    begin("disabled by");
    for (const Disabler& by : disabled_by) {
      const model::Unit& disabler = plant_.units[by.unit];
      row(fmt::format("{}.{}", disabler.path, disabler.states[by.state].name));
    }
  }

  void add_values(const model::Unit& unit) {
    begin("values");
    for (const std::uint32_t value : unit.values) row(std::string(plant_.symbols[value].name()));
  }

  void add_behaviour(const model::Unit& unit) {
    begin("behaviour");
    row(unit.described->behaviour);
    for (std::size_t i = unit.first_input; i < unit.conditions.size(); ++i) {
      row(fmt::format("input {}: {}", unit.input_names[i - unit.first_input],
                      model::condition_text(unit.conditions[i], plant_)));
    }
    for (const std::uint32_t value : unit.values) row(fmt::format("value {}", plant_.symbols[value].name()));
  }

  void add_counts() {
    std::array<std::size_t, name::kAccounts> counts{};
    for (const model::Symbol& symbol : plant_.symbols) {
      const bool in_device = symbol.unit_of_device() != model::kNone;
      ++counts[static_cast<std::size_t>(in_device ? name::Account::modelled : symbol.account)];
    }
    const std::size_t unmodelled = plant_.symbols.size() - counts[0];
    line(fmt::format("{} device{}, {} I/O symbol{}, {} of them in no device", plant_.units.size(),
                     plant_.units.size() == 1 ? "" : "s", plant_.symbols.size(), plant_.symbols.size() == 1 ? "" : "s",
                     unmodelled));
    for (std::size_t reason = 1; reason < counts.size(); ++reason) {
      if (counts[reason] == 0) continue;
      line(fmt::format("  {}: {}", counts[reason], unmodelled_reason(static_cast<model::Account>(reason))));
    }
  }

  const model::PlantModel& plant_;
  const CrossReferences references_;
  base::PartCollector text_;
  std::string_view element_;
};

}  // namespace

View model_table(const Scene& scene) {
  return {[scene](base::TextSink& sink) { TableWriter(scene.plant, sink).write(scene.units); }};
}

}  // namespace symplant::view

// State charts as SCXML.
#include "view/scxml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "diag/encode.hpp"
#include "elements/requirement/words.hpp"
#include "model/condition_text.hpp"
#include "symplant/tables/duration.hpp"
#include "text/identifier.hpp"
#include "view/cross_references.hpp"
#include "view/scxml_names.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

using diag::markup_text;
using model::kNone;

constexpr std::string_view kScxmlHead =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<!-- A view, not the model: written by symplant, not read by it. Attributes and elements of the namespace\n"
    "     urn:symplant:model:1, which SCXML tools ignore, hold what SCXML cannot express: travel times (here a device\n"
    "     is in its target state at once), the actuation and spring returns, disabled devices, requirements, random\n"
    "     times (a delay is the minimum or the mean). Commands are levels in the model and events here, and a delay\n"
    "     counts from entering a state, not from when its condition holds. -->\n";

constexpr std::string_view kNoMaterial =
    "<!-- The material flow is left out: tracks, places, transfers, work and sources. The numbers of parts in "
    "conditions\n"
    "     are data that nothing changes. -->\n";

/// `name="value"` with a blank before it.
std::string attribute(std::string_view name, std::string_view value) {
  return fmt::format(" {}=\"{}\"", name, markup_text(value));
}

class ScxmlWriter {
 public:
  explicit ScxmlWriter(const Scene& scene)
      : scene_(scene), plant_(scene.plant), references_(cross_references(scene.plant)), names_(scene.plant) {}

  std::string write() {
    for (const std::uint32_t unit : scene_.units) add_unit(unit);
    std::string document(kScxmlHead);
    if (!plant_.material.empty()) document += kNoMaterial;
    document +=
        "<scxml xmlns=\"http://www.w3.org/2005/07/scxml\" xmlns:symplant=\"urn:symplant:model:1\" version=\"1.0\"";
    document += attribute("name", text::identifier(plant_.name)) + " datamodel=\"ecmascript\" initial=\"plant\">\n";
    std::sort(variables_.begin(), variables_.end());
    variables_.erase(std::unique(variables_.begin(), variables_.end()), variables_.end());
    if (!variables_.empty()) document += "  <datamodel>\n";
    for (const std::string& variable : variables_) document += "    <data id=\"" + variable + "\" expr=\"0\"/>\n";
    if (!variables_.empty()) document += "  </datamodel>\n";
    document += "  <parallel id=\"plant\">\n" + text_ + "  </parallel>\n";
    for (const model::Requirement& requirement : plant_.requirements) {
      document += "  <symplant:requirement" + attribute("name", requirement.name) +
                  attribute("is", requirement_text(requirement, plant_)) + "/>\n";
    }
    return document + "</scxml>\n";
  }

 private:
  template <class... Values>
  void out(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }

  void add_unit(std::uint32_t index) {
    const model::Unit& unit = plant_.units[index];
    out("    <state id=\"{}\" initial=\"{}\"{}{}{}", names_.unit(index), names_.state(index, unit.initial),
        attribute("symplant:path", unit.path),
        attribute("symplant:actuation", description::actuation_name(unit.actuation)),
        attribute("symplant:initial-from", initial_key(unit.initial_from)));
    if (unit.rest != kNone) text_ += attribute("symplant:rest", unit.states[unit.rest].name);
    if (unit.has_behaviour()) text_ += attribute("symplant:behaviour", unit.described->behaviour);
    text_ += ">\n";
    add_signals("I", unit.operations);
    add_signals("O", unit.events);
    add_signals("value", unit.values);
    for (std::size_t i = unit.first_input; i < unit.conditions.size(); ++i) {
      out("      <symplant:input{}{}/>\n", attribute("name", unit.input_names[i - unit.first_input]),
          attribute("is", model::condition_text(unit.conditions[i], plant_)));
    }
    for (const Disabler& by : references_.disabled_by[index]) {
      out("      <symplant:disabled-by{}{}/>\n", attribute("device", plant_.units[by.unit].path),
          attribute("state", plant_.units[by.unit].states[by.state].name));
    }
    std::vector<model::Transition> routes = spring_returns(unit);
    std::copy_if(unit.transitions.begin(), unit.transitions.end(), std::back_inserter(routes),
                 [](const model::Transition& t) { return t.spring_return; });
    for (const model::Transition& t : routes) {
      out("      <symplant:spring-way{}{}{}/>\n", attribute("from", unit.states[t.from].name),
          attribute("to", unit.states[t.to].name), attribute("takes", duration_text(t.takes)));
    }
    for (std::uint32_t state = 0; state < unit.states.size(); ++state) add_state(index, state);
    text_ += "    </state>\n";
  }

  void add_signals(std::string_view element, const std::vector<std::uint32_t>& side) {
    for (const std::uint32_t position : side) {
      const model::Symbol& symbol = plant_.symbols[position];
      out("      <symplant:signal element=\"{}\" event=\"{}\"{}{}{}{} row=\"{}\"/>\n", element, names_.symbol(position),
          attribute("name", symbol.name()), attribute("address", symbol.row->vendor_address),
          attribute("iec-address", symbol.row->iec_address), attribute("list", plant_.list_of(symbol).name()),
          symbol.row->line);
    }
  }

  bool delayed(const model::Transition& t) const { return t.on == kNone && !t.spring_return && !t.after.is_zero(); }
  std::string delay_name(std::uint32_t unit, std::size_t position) const {
    return fmt::format("after.{}.{}", names_.unit(unit), position);
  }

  void add_state(std::uint32_t index, std::uint32_t state) {
    const model::Unit& unit = plant_.units[index];
    out("      <state id=\"{}\"{}", names_.state(index, state), attribute("symplant:name", unit.states[state].name));
    const auto add_symbol = [&](std::string_view name, const std::vector<std::uint32_t>& side, std::uint32_t position) {
      if (position != kNone) text_ += attribute(name, plant_.symbols[side[position]].name());
    };
    add_symbol("symplant:operation", unit.operations, unit.states[state].operation);
    add_symbol("symplant:event", unit.events, unit.states[state].event);
    text_ += ">\n";
    if (state < unit.disables.size()) {
      for (const std::uint32_t other : unit.disables[state]) {
        out("        <symplant:disables{}/>\n", attribute("device", plant_.units[other].path));
      }
    }
    add_actions(index, state, true);
    add_actions(index, state, false);
    for (std::size_t position = 0; position < unit.transitions.size(); ++position) {
      if (unit.transitions[position].from == state) add_transition(index, position);
    }
    text_ += "      </state>\n";
  }

  /// The events that entering or leaving a state switches, and the delays that it starts or cancels.
  void add_actions(std::uint32_t index, std::uint32_t state, bool entering) {
    const model::Unit& unit = plant_.units[index];
    std::string actions;
    for (const auto& [event, on] : switched(unit, state, entering)) {
      actions += "          <raise event=\"" + names_.change(unit.events[event], on) + "\"/>\n";
    }
    for (std::size_t position = 0; position < unit.transitions.size(); ++position) {
      const model::Transition& t = unit.transitions[position];
      if (t.from != state || !delayed(t)) continue;
      const std::string name = delay_name(index, position);
      actions += entering ? fmt::format("          <send id=\"{0}\" event=\"{0}\" delay=\"{1}\"/>\n", name,
                                        tables::duration_text(t.after.a))
                          : fmt::format("          <cancel sendid=\"{}\"/>\n", name);
    }
    if (!actions.empty()) out("        <{0}>\n{1}        </{0}>\n", entering ? "onentry" : "onexit", actions);
  }

  void add_transition(std::uint32_t index, std::size_t position) {
    const model::Unit& unit = plant_.units[index];
    const model::Transition& t = unit.transitions[position];
    if (t.spring_return) return;
    text_ += "        <transition";
    if (t.on != kNone) text_ += attribute("event", names_.change(unit.operations[t.on], true));
    if (delayed(t)) text_ += attribute("event", delay_name(index, position));
    if (t.when != kNone) text_ += attribute("cond", names_.expression(unit.conditions[t.when], variables_));
    text_ += attribute("target", names_.state(index, t.to));
    if (t.when != kNone) {
      text_ += attribute("symplant:when", model::condition_text(unit.conditions[t.when], plant_));
    }
    if (!t.after.is_zero()) text_ += attribute("symplant:after", duration_text(t.after));
    if (!t.takes.is_zero()) text_ += attribute("symplant:takes", duration_text(t.takes));
    if (t.during != kNone) {
      text_ += attribute("symplant:while", model::condition_text(unit.conditions[t.during], plant_));
    }
    for (const tables::TransitionNumber& number : tables::kTransitionNumbers) {
      const std::uint32_t value = t.numbers.*number.member;
      if (value != 0) text_ += attribute(fmt::format("symplant:{}", number.key), std::to_string(value));
    }
    if (t.once) text_ += attribute("symplant:once", "true");
    text_ += attribute("symplant:origin", origin_text(t.origin)) + fmt::format(" symplant:place=\"{}\"/>\n", position);
  }

  const Scene& scene_;
  const model::PlantModel& plant_;
  const CrossReferences references_;
  const ScxmlNames names_;
  std::string text_;
  std::vector<std::string> variables_;
};

}  // namespace

View scxml_view(const Scene& scene) { return {base::whole(ScxmlWriter(scene).write())}; }

}  // namespace symplant::view

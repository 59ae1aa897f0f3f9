// The data of the page: symbols, devices, and the structures and layouts that devices share.
#include "view/html_data.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <utility>

#include "check/rule.hpp"
#include "diag/encode.hpp"
#include "diag/visible_text.hpp"
#include "model/classify.hpp"
#include "model/condition_text.hpp"
#include "symplant/tables/digest.hpp"
#include "view/chart.hpp"
#include "view/cross_references.hpp"
#include "view/layout.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

using Json = nlohmann::ordered_json;
using diag::visible;
using model::kNone;

int place_or_none(std::uint32_t position) { return position == kNone ? -1 : static_cast<int>(position); }

/// A layout as arrays of numbers, which the page draws unchanged.
Json layout_json(const LayoutKey& key) {
  const Layout layout = lay_out(key);
  Json states = Json::array();
  for (const Point& state : layout.states) states.push_back({state.x, state.y});
  Json arrows = Json::array();
  for (std::size_t i = 0; i < layout.arrows.size(); ++i) {
    const ArrowPosition& arrow = layout.arrows[i];
    arrows.push_back({arrow.begin.x, arrow.begin.y, arrow.control.x, arrow.control.y, arrow.end.x, arrow.end.y,
                      arrow.label.x, arrow.label.y, key.arrows[i].columns * kLetterWidth});
  }
  return {{"width", layout.width},
          {"height", layout.height},
          {"box", {layout.box_width, layout.box_height}},
          {"states", std::move(states)},
          {"arrows", std::move(arrows)}};
}

class DataWriter {
 public:
  explicit DataWriter(const Scene& scene)
      : scene_(scene), plant_(scene.plant), references_(cross_references(scene.plant)) {}

  Json write() {
    Json units = Json::array();
    number_units_and_symbols();
    for (const std::uint32_t unit : scene_.units) units.push_back(unit_json(unit));
    Json symbols = Json::array();
    for (std::uint32_t i = 0; i < plant_.symbols.size(); ++i) {
      if (symbol_positions_[i] >= 0) symbols.push_back(symbol_json(plant_.symbols[i]));
    }
    Json requirements = Json::array();
    for (const model::Requirement& requirement : plant_.requirements) {
      requirements.push_back({visible(requirement.name), visible(requirement_text(requirement, plant_))});
    }
    Json reasons = Json::array();
    for (int reason = 0; reason <= static_cast<int>(model::Unmodelled::unit_too_large); ++reason) {
      reasons.push_back(unmodelled_reason(static_cast<model::Unmodelled>(reason)));
    }
    Json lists = Json::array();
    for (const model::PlantList& list : plant_.lists) {
      const std::string& controller = plant_.controllers[list.controller];
      lists.push_back(visible(list.name() + (controller.empty() ? "" : " of " + controller)));
    }
    Json types = Json::array();
    for (int type = 0; type <= static_cast<int>(tables::DataType::lreal); ++type) {
      types.push_back(model::data_type_name(static_cast<tables::DataType>(type)));
    }
    Json internal = Json::array();
    for (std::size_t i = 0; i < model::kInternalReasons; ++i) {
      internal.push_back({model::internal_reason_text(static_cast<model::InternalReason>(i)), plant_.internal[i]});
    }
    return {
        {"plant", visible(plant_.name)},  {"hash", fmt::format("{:016x}", tables::model_hash(scene_.tables.tables()))},
        {"lists", std::move(lists)},      {"types", std::move(types)},
        {"reasons", std::move(reasons)},  {"internal", std::move(internal)},
        {"layouts", std::move(layouts_)}, {"kinds", std::move(kinds_)},
        {"units", std::move(units)},      {"requirements", std::move(requirements)},
        {"symbols", std::move(symbols)}};
  }

 private:
  /// If all devices are shown, all symbols are, too; otherwise only the symbols of the devices shown.
  void number_units_and_symbols() {
    unit_positions_.assign(plant_.units.size(), -1);
    for (std::size_t i = 0; i < scene_.units.size(); ++i) unit_positions_[scene_.units[i]] = static_cast<int>(i);
    const bool all = scene_.units.size() == plant_.units.size();
    std::vector<bool> shown(plant_.symbols.size(), all);
    for (const std::uint32_t unit : scene_.units) {
      for (const auto* side :
           {&plant_.units[unit].operations, &plant_.units[unit].events, &plant_.units[unit].values}) {
        for (const std::uint32_t symbol : *side) shown[symbol] = true;
      }
    }
    symbol_positions_.assign(plant_.symbols.size(), -1);
    int next = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
      if (shown[i]) symbol_positions_[i] = next++;
    }
  }

  /// The elements are in the order of the index constants of page.js.
  Json symbol_json(const model::Symbol& symbol) const {
    const std::string initial = initial_value_text(symbol);
    Json row{visible(symbol.name()),
             symbol.row->line,
             symbol.list,
             symbol.direction == tables::Direction::event ? 1 : 0,
             static_cast<int>(symbol.type),
             visible(symbol.row->vendor_address),
             visible(symbol.row->iec_address),
             symbol.initial == 0 ? "" : initial,
             symbol.unit == kNone ? -1 : unit_positions_[symbol.unit],
             static_cast<int>(symbol.unmodelled)};
    if (symbol.leader != kNone) row.push_back(visible(plant_.symbols[symbol.leader].name()));
    return row;
  }

  Json positions(const std::vector<std::uint32_t>& symbols) const {
    Json list = Json::array();
    for (const std::uint32_t symbol : symbols) list.push_back(symbol_positions_[symbol]);
    return list;
  }

  Json tasks(const std::vector<std::uint32_t>& symbols) const {
    Json list = Json::array();
    for (const std::uint32_t symbol : symbols) list.push_back(visible(plant_.symbols[symbol].reading.task));
    return list;
  }

  Json transition_json(const model::Transition& t, const model::Unit& unit) const {
    const TransitionText transition = transition_text(t, unit, plant_);
    return {
        t.from,           t.to,           visible(transition.on), t.when == kNone ? 0 : t.when + 1, transition.after,
        transition.takes, t.once ? 1 : 0, origin_text(t.origin)};
  }

  Json outputs(const model::Unit& unit, bool entering) const {
    Json states = Json::array();
    for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
      Json events = Json::array();
      for (const auto& [event, on] : switched(unit, s, entering)) events.push_back({event, on ? 1 : 0});
      states.push_back(std::move(events));
    }
    return states;
  }

  std::size_t layout_of(const Chart& chart) {
    const auto [position, added] = layout_positions_.try_emplace(layout_key(chart), layouts_.size());
    if (added) layouts_.push_back(layout_json(position->first));
    return position->second;
  }

  /// The index of a unit's structure: all data that is equal in units of the same structure.
  std::size_t kind_of(const model::Unit& unit) {
    const Chart chart = chart_of(unit, plant_, Conditions::by_number);
    Json states = Json::array();
    for (const ChartState& state : chart.states) states.push_back({visible(state.name), visible(state.symbols)});
    Json edges = Json::array();
    for (const ChartEdge& edge : chart.edges) {
      Json label = Json::array();
      for (const std::string& line : edge.label) label.push_back(visible(line));
      edges.push_back({edge.from == kEveryOther ? -1 : static_cast<int>(edge.from), edge.to, edge.automatic ? 1 : 0,
                       std::move(label)});
    }
    Json internal = Json::array();
    Json external = Json::array();
    std::vector<model::Transition> transitions = unit.transitions;
    for (const model::Transition& transition : spring_returns(unit)) transitions.push_back(transition);
    for (const model::Transition& t : transitions) {
      (t.on == kNone ? internal : external).push_back(transition_json(t, unit));
    }
    Json kind{{"actuation", description::actuation_name(unit.actuation)},
              {"rest", place_or_none(unit.rest)},
              {"inferences", inferences(unit)},
              {"states", std::move(states)},
              {"operations", tasks(unit.operations)},
              {"events", tasks(unit.events)},
              {"edges", std::move(edges)},
              {"internal", std::move(internal)},
              {"external", std::move(external)},
              {"enter", outputs(unit, true)},
              {"leave", outputs(unit, false)},
              {"layout", layout_of(chart)}};
    const auto [position, added] = kind_positions_.try_emplace(kind.dump(), kinds_.size());
    if (added) kinds_.push_back(std::move(kind));
    return position->second;
  }

  Json unit_json(std::uint32_t index) {
    const model::Unit& unit = plant_.units[index];
    const name::NameReading& reading = check::first_symbol_of(plant_, unit).reading;
    Json json{{"path", visible(unit.path)},
              {"line", visible(reading.line)},
              {"process", visible(reading.process)},
              {"device", visible(unit.device)},
              {"kind", kind_of(unit)},
              {"initial", unit.initial},
              {"why", initial_reason(unit.initial_from)},
              {"operations", positions(unit.operations)},
              {"events", positions(unit.events)}};
    if (unit.described != nullptr && !unit.described->type.empty()) json["type"] = visible(unit.described->type);
    if (!unit.values.empty()) json["values"] = positions(unit.values);
    for (std::uint32_t i = 0; i < unit.first_input; ++i) {
      json["conditions"].push_back(visible(model::condition_text(unit.conditions[i], plant_)));
    }
    if (unit.has_behaviour()) {
      json["behaviour"] = visible(unit.described->behaviour);
      json["inputs"] = Json::array();
      for (std::size_t i = unit.first_input; i < unit.conditions.size(); ++i) {
        json["inputs"].push_back({visible(unit.input_names[i - unit.first_input]),
                                  visible(model::condition_text(unit.conditions[i], plant_))});
      }
    }
    for (std::size_t s = 0; s < unit.disables.size(); ++s) {
      for (const std::uint32_t other : unit.disables[s]) {
        json["disables"].push_back({s, visible(plant_.units[other].path)});
      }
    }
    for (const Disabler& by : references_.disabled_by[index]) {
      json["disabledBy"].push_back(
          {visible(plant_.units[by.unit].path), visible(plant_.units[by.unit].states[by.state].name)});
    }
    if (!references_.requirements[index].empty()) json["requirements"] = references_.requirements[index];
    return json;
  }

  const Scene& scene_;
  const model::PlantModel& plant_;
  const CrossReferences references_;
  std::vector<int> unit_positions_;    // index in the page; -1 if the unit is not shown
  std::vector<int> symbol_positions_;  // index in the page; -1 if the symbol is not shown
  std::map<LayoutKey, std::size_t> layout_positions_;
  std::unordered_map<std::string, std::size_t> kind_positions_;
  Json layouts_ = Json::array();
  Json kinds_ = Json::array();
};

}  // namespace

std::string html_data(const Scene& scene) {
  return diag::script_json(DataWriter(scene).write().dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace symplant::view

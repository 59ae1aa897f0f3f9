// The derived models as JSON, for programs.
#include "view/model_json.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "check/rule.hpp"
#include "model/classify.hpp"
#include "model/condition_text.hpp"
#include "symplant/tables/digest.hpp"
#include "view/cross_references.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

using Json = nlohmann::ordered_json;
using model::kNone;

Json names(const std::vector<std::uint32_t>& side, const model::PlantModel& plant) {
  Json list = Json::array();
  for (const std::uint32_t index : side) list.push_back(plant.symbols[index].name());
  return list;
}

/// Nanoseconds, or the parameters of a random time.
Json time_json(const description::Duration& time) {
  switch (time.kind) {
    case description::Duration::Kind::fixed:
      break;
    case description::Duration::Kind::uniform:
      return {{"min", time.a}, {"max", time.b}};
    case description::Duration::Kind::normal:
      return {{"mean", time.a}, {"sigma", time.b}};
  }
  return time.a;
}

/// The exact initial value: integers beyond 2^53, NaN and infinities are strings.
Json value_json(const model::Symbol& symbol) {
  using tables::DataType;
  if (symbol.type == DataType::boolean) return symbol.initial != 0;
  if (symbol.type == DataType::real || symbol.type == DataType::lreal) {
    const auto value = std::bit_cast<double>(symbol.initial);
    return std::isfinite(value) ? Json(value) : Json(initial_value_text(symbol));
  }
  const std::string text = initial_value_text(symbol);
  return text.size() < 16 ? Json::parse(text) : Json(text);
}

class UnitWriter {
 public:
  UnitWriter(const model::Unit& unit, const model::PlantModel& plant) : unit_(unit), plant_(plant) {}

  Json write(const std::vector<Disabler>& disabled_by) const {
    const name::NameReading& reading = check::first_symbol_of(plant_, unit_).reading;
    Json json{{"path", unit_.path},
              {"line", reading.line},
              {"process", reading.process},
              {"device", unit_.device},
              {"actuation", description::actuation_name(unit_.actuation)},
              {"travel", unit_.travel},
              {"initial", unit_.states[unit_.initial].name},
              {"initial_from", initial_key(unit_.initial_from)}};
    if (unit_.rest != kNone) json["rest"] = unit_.states[unit_.rest].name;
    json["inferences"] = inferences(unit_);
    json["I"] = names(unit_.operations, plant_);
    json["O"] = names(unit_.events, plant_);
    json["S"] = states();
    json["d_ext"] = transitions(true);
    json["d_int"] = transitions(false);
    json["l_enter"] = outputs(true);
    json["l_leave"] = outputs(false);
    json["l_disable"] = disables();
    json["disabled_by"] = Json::array();
    for (const Disabler& by : disabled_by) {
      const model::Unit& disabler = plant_.units[by.unit];
      json["disabled_by"].push_back({{"unit", disabler.path}, {"state", disabler.states[by.state].name}});
    }
    if (unit_.described != nullptr && !unit_.described->type.empty()) json["type"] = unit_.described->type;
    if (unit_.has_behaviour()) json["behaviour"] = behaviour();
    return json;
  }

 private:
  std::string_view operation(std::uint32_t position) const { return plant_.symbols[unit_.operations[position]].name(); }
  std::string_view event(std::uint32_t position) const { return plant_.symbols[unit_.events[position]].name(); }

  Json states() const {
    Json list = Json::array();
    for (const model::State& state : unit_.states) {
      Json row{{"name", state.name}};
      if (state.operation != kNone) row["operation"] = operation(state.operation);
      if (state.event != kNone) row["event"] = event(state.event);
      list.push_back(std::move(row));
    }
    return list;
  }

  Json transitions(bool commanded) const {
    Json list = Json::array();
    for (std::size_t n = 0; n < unit_.transitions.size(); ++n) {
      const model::Transition& t = unit_.transitions[n];
      if ((t.on != kNone) != commanded) continue;
      Json row{{"place", n}, {"from", unit_.states[t.from].name}, {"to", unit_.states[t.to].name}};
      if (commanded) row["on"] = operation(t.on);
      if (t.when != kNone) row["when"] = model::condition_text(unit_.conditions[t.when], plant_);
      row["after"] = time_json(t.after);
      row["takes"] = time_json(t.takes);
      if (t.once) row["once"] = true;
      if (t.spring_return) row["spring_way"] = true;
      row["origin"] = origin_text(t.origin);
      list.push_back(std::move(row));
    }
    return list;
  }

  Json outputs(bool entering) const {
    Json object = Json::object();
    for (std::uint32_t s = 0; s < unit_.states.size(); ++s) {
      Json list = Json::array();
      for (const auto& [position, on] : switched(unit_, s, entering))
        list.push_back({{"event", event(position)}, {"on", on}});
      if (!list.empty()) object[unit_.states[s].name] = std::move(list);
    }
    return object;
  }

  Json disables() const {
    Json object = Json::object();
    for (std::size_t s = 0; s < unit_.disables.size(); ++s) {
      Json list = Json::array();
      for (const std::uint32_t other : unit_.disables[s]) list.push_back(plant_.units[other].path);
      if (!list.empty()) object[unit_.states[s].name] = std::move(list);
    }
    return object;
  }

  Json behaviour() const {
    Json inputs = Json::array();
    for (std::size_t i = unit_.first_input; i < unit_.conditions.size(); ++i) {
      inputs.push_back({{"name", unit_.input_names[i - unit_.first_input]},
                        {"condition", model::condition_text(unit_.conditions[i], plant_)}});
    }
    return {
        {"class", unit_.described->behaviour}, {"inputs", std::move(inputs)}, {"values", names(unit_.values, plant_)}};
  }

  const model::Unit& unit_;
  const model::PlantModel& plant_;
};

Json symbol_json(const model::Symbol& symbol, const model::PlantModel& plant) {
  Json json{{"name", symbol.name()},
            {"list", symbol.list},
            {"row", symbol.row->line},
            {"direction", check::direction_text(symbol.direction)},
            {"type", model::data_type_name(symbol.type)},
            {"address", symbol.row->vendor_address},
            {"iec_address", symbol.row->iec_address},
            {"initial", value_json(symbol)},
            {"unit", symbol.unit == kNone ? Json() : Json(plant.units[symbol.unit].path)}};
  if (symbol.unmodelled != model::Unmodelled::modelled) json["unmodelled"] = unmodelled_key(symbol.unmodelled);
  if (symbol.leader != kNone) json["follows"] = plant.symbols[symbol.leader].name();
  return json;
}

/// The lists by file name, with the controller if it has a name.
Json lists_json(const model::PlantModel& plant) {
  Json lists = Json::array();
  for (const model::PlantList& list : plant.lists) {
    lists.push_back({{"file", list.name()}});
    const std::string& controller = plant.controllers[list.controller];
    if (!controller.empty()) lists.back()["controller"] = controller;
  }
  return lists;
}

Json requirement_json(const model::Requirement& requirement, const model::PlantModel& plant) {
  Json json{{"name", requirement.name}};
  const std::string condition = model::condition_text(requirement.condition, plant);
  if (requirement.kind == tables::RequirementRow::Kind::never) {
    json["never"] = condition;
  } else {
    json["after"] = condition;
    json["expect"] = model::condition_text(requirement.expected, plant);
    json["within"] = requirement.within;
  }
  return json;
}

}  // namespace

View model_json(const Scene& scene) {
  const model::PlantModel& plant = scene.plant;
  const CrossReferences references = cross_references(plant);
  Json units = Json::array();
  for (const std::uint32_t unit : scene.units) {
    units.push_back(UnitWriter(plant.units[unit], plant).write(references.disabled_by[unit]));
  }
  Json symbols = Json::array();
  for (const model::Symbol& symbol : plant.symbols) symbols.push_back(symbol_json(symbol, plant));
  Json requirements = Json::array();
  for (const model::Requirement& requirement : plant.requirements) {
    requirements.push_back(requirement_json(requirement, plant));
  }
  Json internal = Json::object();
  for (std::size_t i = 0; i < model::kInternalReasons; ++i) {
    internal[std::string(model::internal_reason_text(static_cast<model::InternalReason>(i)))] = plant.internal[i];
  }
  const Json json{{"symplant-model", kModelJsonVersion},
                  {"plant", plant.name},
                  {"lists", lists_json(plant)},
                  {"model_hash", fmt::format("{:016x}", tables::model_hash(scene.tables.tables()))},
                  {"units", std::move(units)},
                  {"requirements", std::move(requirements)},
                  {"symbols", std::move(symbols)},
                  {"internal_rows", std::move(internal)}};
  return {json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"};
}

}  // namespace symplant::view

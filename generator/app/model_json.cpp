// The derived models for programs.
#include "app/model_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "check/rule.hpp"
#include "model/classify.hpp"
#include "symplant/core/digest.hpp"

namespace symplant::app {
namespace {

using Json = nlohmann::ordered_json;
using model::kNone;

std::string_view unmodelled_text(model::Unmodelled reason) {
  switch (reason) {
    case model::Unmodelled::modelled:
      return "";
    case model::Unmodelled::numeric:
      return "numeric";
    case model::Unmodelled::name:
      return "name";
    case model::Unmodelled::task_taken:
      return "task-taken";
    case model::Unmodelled::unit_too_large:
      return "unit-too-large";
  }
  return "";
}

Json names(const std::vector<std::uint32_t>& side, const model::PlantModel& plant) {
  Json list = Json::array();
  for (const std::uint32_t index : side) list.push_back(plant.symbols[index].name());
  return list;
}

/// Nanoseconds, or how they are drawn.
Json time_json(const model::Duration& time) {
  switch (time.kind) {
    case model::Duration::Kind::fixed:
      break;
    case model::Duration::Kind::uniform:
      return {{"min", time.a}, {"max", time.b}};
    case model::Duration::Kind::normal:
      return {{"mean", time.a}, {"sigma", time.b}};
  }
  return time.a;
}

std::string_view origin_text(model::Origin origin) {
  switch (origin) {
    case model::Origin::given:
      return "given";
    case model::Origin::derived:
      return "derived";
    case model::Origin::inferred:
      return "inferred";
  }
  return "";
}

Json unit_json(const model::Unit& unit, const model::PlantModel& plant) {
  Json d_ext = Json::array();
  Json d_int = Json::array();
  for (const model::Transition& t : unit.transitions) {
    Json row{{"from", unit.states[t.from].name}, {"to", unit.states[t.to].name}};
    if (t.on != kNone) row["on"] = plant.symbols[unit.operations[t.on]].name();
    row["after"] = time_json(t.after);
    row["takes"] = time_json(t.takes);
    row["origin"] = origin_text(t.origin);
    (t.on != kNone ? d_ext : d_int).push_back(std::move(row));
  }
  Json states = Json::array();
  Json lambda = Json::object();
  for (const model::State& state : unit.states) {
    states.push_back(state.name);
    if (state.event != kNone) lambda[state.name] = Json::array({plant.symbols[unit.events[state.event]].name()});
  }
  const bool springs = unit.actuation == core::Actuation::spring;
  Json json{{"path", unit.path},
            {"actuation", model::actuation_name(unit.actuation)},
            {"initial", unit.states[unit.initial].name}};
  if (springs) json["rest"] = unit.states[unit.rest].name;
  json["I"] = names(unit.operations, plant);
  json["O"] = names(unit.events, plant);
  json["S"] = std::move(states);
  json["d_ext"] = std::move(d_ext);
  json["d_int"] = std::move(d_int);
  json["l_enter"] = lambda;
  json["l_leave"] = lambda;
  json["l_disable"] = Json::object();
  return json;
}

Json symbol_json(const model::Symbol& symbol, const model::PlantModel& plant) {
  Json json{{"name", symbol.name()},
            {"list", symbol.list},
            {"row", symbol.row->line},
            {"direction", check::direction_text(symbol.direction)},
            {"type", model::data_type_name(symbol.type)},
            {"address", symbol.row->vendor_address},
            {"iec_address", symbol.row->iec_address},
            {"unit", symbol.unit == kNone ? Json() : Json(plant.units[symbol.unit].path)}};
  if (symbol.unmodelled != model::Unmodelled::modelled) json["unmodelled"] = unmodelled_text(symbol.unmodelled);
  if (symbol.leader != kNone) json["follows"] = plant.symbols[symbol.leader].name();
  return json;
}

/// The lists, by file name; a controller that has a name is named.
Json lists_json(const model::PlantModel& plant) {
  Json lists = Json::array();
  for (const model::PlantList& list : plant.lists) {
    lists.push_back({{"file", list.name()}});
    const std::string& controller = plant.controllers[list.controller];
    if (!controller.empty()) lists.back()["controller"] = controller;
  }
  return lists;
}

}  // namespace

std::string model_json(const model::PlantModel& plant, const lower::EngineTables& tables,
                       const std::vector<std::uint32_t>& units) {
  Json devices = Json::array();
  for (const std::uint32_t unit : units) devices.push_back(unit_json(plant.units[unit], plant));
  Json symbols = Json::array();
  for (const model::Symbol& symbol : plant.symbols) symbols.push_back(symbol_json(symbol, plant));
  Json internal = Json::object();
  for (std::size_t i = 0; i < model::kInternalReasons; ++i) {
    internal[std::string(model::internal_reason_text(static_cast<model::InternalReason>(i)))] = plant.internal[i];
  }
  const Json json{
      {"symplant-model", kModelJsonVersion}, {"plant", plant.name},
      {"lists", lists_json(plant)},          {"model_hash", fmt::format("{:016x}", core::model_hash(tables.tables()))},
      {"units", std::move(devices)},         {"symbols", std::move(symbols)},
      {"internal_rows", std::move(internal)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace symplant::app

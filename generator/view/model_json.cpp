// The derived models as JSON, for programs.
#include "view/model_json.hpp"

#include <fmt/format.h>

#include <array>

#include "elements/alarm/json.hpp"
#include "elements/follow/json.hpp"
#include "elements/malfunction/json.hpp"
#include "elements/material/json.hpp"
#include "elements/requirement/json.hpp"
#include "elements/value/json.hpp"
#include "model/classify.hpp"
#include "model/condition_text.hpp"
#include "symplant/tables/digest.hpp"
#include "view/cross_references.hpp"
#include "view/duration_json.hpp"
#include "view/json_writer.hpp"
#include "view/value_json.hpp"
#include "view/words.hpp"

namespace symplant::view {
namespace {

using model::kNone;

void write_names(const std::vector<std::uint32_t>& side, const model::PlantModel& plant, JsonWriter& json) {
  json.array(side, [&](std::uint32_t index) { json.value(plant.symbols[index].name()); });
}

class UnitWriter {
 public:
  UnitWriter(const model::Unit& unit, const model::PlantModel& plant, JsonWriter& json)
      : unit_(unit), plant_(plant), json_(json) {}

  void write(const std::vector<Disabler>& disabled_by) {
    json_.begin_object();
    write_head();
    json_.key("I");
    write_names(unit_.operations, plant_, json_);
    json_.key("O");
    write_names(unit_.events, plant_, json_);
    write_states();
    write_transitions("d_ext", true);
    write_transitions("d_int", false);
    write_outputs("l_enter", true);
    write_outputs("l_leave", false);
    write_disables();
    json_.key("disabled_by");
    json_.array(disabled_by, [&](const Disabler& by) {
      const model::Unit& disabler = plant_.units[by.unit];
      json_.begin_object();
      json_.member("unit", disabler.path);
      json_.member("state", disabler.states[by.state].name);
      json_.end_object();
    });
    if (unit_.described != nullptr && !unit_.described->type.empty()) json_.member("type", unit_.described->type);
    if (!unit_.values.empty()) {
      json_.key("values");
      write_names(unit_.values, plant_, json_);
    }
    if (unit_.has_behaviour()) write_behaviour();
    json_.end_object();
  }

 private:
  std::string_view operation(std::uint32_t position) const { return plant_.symbols[unit_.operations[position]].name(); }
  std::string_view event(std::uint32_t position) const { return plant_.symbols[unit_.events[position]].name(); }

  void write_head() {
    const model::SymbolReading& reading = plant_.symbols[unit_.first_symbol()].reading;
    json_.member("path", unit_.path);
    json_.member("line", reading.line());
    json_.member("process", reading.process());
    json_.member("device", unit_.device);
    if (unit_.facet != nullptr && !unit_.facet->name.empty()) json_.member("facet", unit_.facet->name);
    json_.member("actuation", description::actuation_name(unit_.actuation));
    json_.member("travel", unit_.travel);
    if (unit_.overrun != tables::kNever) json_.member("overrun", unit_.overrun);
    json_.member("initial", unit_.states[unit_.initial].name);
    json_.member("initial_from", initial_key(unit_.initial_from));
    if (unit_.rest != kNone) json_.member("rest", unit_.states[unit_.rest].name);
    json_.key("inferences");
    json_.array(inferences(unit_), [&](std::string_view sentence) { json_.value(sentence); });
  }

  void write_states() {
    json_.key("S");
    json_.array(unit_.states, [&](const model::State& state) {
      json_.begin_object();
      json_.member("name", state.name);
      if (state.operation != kNone) json_.member("operation", operation(state.operation));
      if (state.event != kNone) json_.member("event", event(state.event));
      json_.end_object();
    });
  }

  void write_transitions(std::string_view element, bool commanded) {
    json_.key(element);
    json_.begin_array();
    for (std::size_t n = 0; n < unit_.transitions.size(); ++n) {
      const model::Transition& t = unit_.transitions[n];
      if ((t.on != kNone) != commanded) continue;
      json_.begin_object();
      json_.member("place", n);
      json_.member("from", unit_.states[t.from].name);
      json_.member("to", unit_.states[t.to].name);
      if (commanded) json_.member("on", operation(t.on));
      if (t.when != kNone) json_.member("when", model::condition_text(unit_.conditions[t.when], plant_));
      json_.key("after");
      write_time(t.after, json_);
      json_.key("takes");
      write_time(t.takes, json_);
      if (t.during != kNone) json_.member("while", model::condition_text(unit_.conditions[t.during], plant_));
      for (const tables::TransitionNumber& number : tables::kTransitionNumbers) {
        if (const std::uint32_t value = t.numbers.*number.member; value != 0) json_.member(number.key, value);
      }
      if (t.once) json_.member("once", true);
      if (t.spring_return) json_.member("spring_way", true);
      json_.member("origin", origin_text(t.origin));
      json_.end_object();
    }
    json_.end_array();
  }

  void write_outputs(std::string_view element, bool entering) {
    json_.key(element);
    json_.begin_object();
    for (std::uint32_t s = 0; s < unit_.states.size(); ++s) {
      const auto events = switched(unit_, s, entering);
      if (events.empty()) continue;
      json_.key(unit_.states[s].name);
      json_.array(events, [&](const auto& output) {
        json_.begin_object();
        json_.member("event", event(output.first));
        json_.member("on", output.second);
        json_.end_object();
      });
    }
    json_.end_object();
  }

  void write_disables() {
    json_.key("l_disable");
    json_.begin_object();
    for (std::size_t s = 0; s < unit_.disables.size(); ++s) {
      if (unit_.disables[s].empty()) continue;
      json_.key(unit_.states[s].name);
      json_.array(unit_.disables[s], [&](std::uint32_t other) { json_.value(plant_.units[other].path); });
    }
    json_.end_object();
  }

  void write_behaviour() {
    json_.key("behaviour");
    json_.begin_object();
    json_.member("class", unit_.described->behaviour);
    json_.key("inputs");
    json_.begin_array();
    for (std::size_t i = unit_.first_input; i < unit_.conditions.size(); ++i) {
      json_.begin_object();
      json_.member("name", unit_.input_names[i - unit_.first_input]);
      json_.member("condition", model::condition_text(unit_.conditions[i], plant_));
      json_.end_object();
    }
    json_.end_array();
    json_.key("values");
    write_names(unit_.values, plant_, json_);
    json_.end_object();
  }

  const model::Unit& unit_;
  const model::PlantModel& plant_;
  JsonWriter& json_;
};

std::string_view direction_by_key(model::DirectionBy by) {
  switch (by) {
    case model::DirectionBy::address:
      return "address";
    case model::DirectionBy::alias:
      return "alias";
    case model::DirectionBy::description:
      return "description";
    case model::DirectionBy::name:
      break;
  }
  return "name";
}

void write_symbol(const model::Symbol& symbol, const model::PlantModel& plant, JsonWriter& json) {
  json.begin_object();
  json.member("name", symbol.name());
  json.member("list", symbol.list);
  json.member("row", symbol.row->line);
  json.member("direction", symbol.direction == tables::Direction::operation ? "operation" : "event");
  json.member("direction_by", direction_by_key(symbol.direction_by));
  json.member("type", model::data_type_name(symbol.type));
  json.member("address", symbol.row->vendor_address);
  json.member("iec_address", symbol.row->iec_address);
  json.key("initial");
  write_value(symbol.type, symbol.initial, json);
  json.key("unit");
  if (symbol.unit_of_device() == kNone) {
    json.null();
  } else {
    json.value(plant.units[symbol.unit_of_device()].path);
  }
  if (symbol.account != model::Account::modelled) json.member("unmodelled", unmodelled_key(symbol.account));
  if (symbol.leader != kNone) json.member("follows", plant.symbols[symbol.leader].name());
  if (symbol.inverted) json.member("inverted", true);
  json.end_object();
}

/// A list by its file name, with the controller if it has a name.
void write_list(const model::PlantList& list, const model::PlantModel& plant, JsonWriter& json) {
  json.begin_object();
  json.member("file", list.name());
  const std::string& controller = plant.controllers[list.controller];
  if (!controller.empty()) json.member("controller", controller);
  json.end_object();
}

/// The elements that are not part of a device, in the order of their members.
constexpr std::array kElements{write_requirements, write_follows,      write_values,
                               write_material,     write_malfunctions, write_alarms};

void write_model(const Scene& scene, JsonWriter& json) {
  const model::PlantModel& plant = scene.plant;
  const CrossReferences references = cross_references(plant);
  json.begin_object();
  json.member("symplant-model", kModelJsonVersion);
  json.member("plant", plant.name);
  json.key("lists");
  json.array(plant.lists, [&](const model::PlantList& list) { write_list(list, plant, json); });
  json.member("model_hash", fmt::format("{:016x}", tables::model_hash(scene.tables.tables())));
  json.key("units");
  json.array(scene.units, [&](std::uint32_t unit) {
    UnitWriter(plant.units[unit], plant, json).write(references.disabled_by[unit]);
  });
  for (const auto write : kElements) write(plant, json);
  json.key("symbols");
  json.array(plant.symbols, [&](const model::Symbol& symbol) { write_symbol(symbol, plant, json); });
  json.key("internal_rows");
  json.begin_object();
  for (std::size_t i = 0; i < model::kInternalReasons; ++i) {
    json.member(model::internal_reason_text(static_cast<model::InternalReason>(i)), plant.internal[i]);
  }
  json.end_object();
  json.end_object();
}

}  // namespace

View model_json(const Scene& scene) {
  return {[scene](base::TextSink& sink) {
    JsonWriter json(sink, JsonWriter::Form::indented);
    write_model(scene, json);
    json.finish();
    sink.put("\n");
  }};
}

}  // namespace symplant::view

// The views of device types, for their classes.
#include "emit/type_view.hpp"

#include <fmt/format.h>

#include <set>

#include "emit/encode.hpp"
#include "emit/model_text.hpp"
#include "emit/row_writer.hpp"
#include "emit/rows.hpp"
#include "text/generated_names.hpp"
#include "text/identifier.hpp"

namespace symplant::emit {
namespace {

using model::kNone;

constexpr std::size_t kDevicesShown = 20;

std::string joined(const std::vector<std::string>& parts, std::string_view prefix = "") {
  std::string out;
  for (const std::string& part : parts) out.append(out.empty() ? "" : ", ").append(prefix).append(part);
  return out;
}

/// The masks of all states on one line, for types without `outputs`.
std::string masks_in_line(const std::vector<tables::EventMasks>& masks) {
  std::vector<std::string> parts;
  parts.reserve(masks.size());
  for (const tables::EventMasks& row : masks) parts.push_back(fmt::format("{{{:#x}, {:#x}}}", row.on, row.off));
  return joined(parts);
}

/// The masks of each state on a separate line, with a comment that names the events.
std::string mask_rows(const std::vector<tables::EventMasks>& masks, const model::Unit& unit,
                      const model::PlantModel& plant) {
  RowWriter rows;
  const auto list = [&](std::uint64_t events, std::string_view word) {
    for (std::size_t e = 0; e < unit.events.size(); ++e) {
      if (((events >> e) & 1U) == 0) continue;
      rows.text(" I_").comment(plant.symbols[unit.events[e]].reading.task).text(word);
    }
  };
  rows.text("\n");
  for (std::size_t s = 0; s < masks.size(); ++s) {
    rows.text("      {").hex(masks[s].on).text(", ").hex(masks[s].off).text("},  // ").comment(unit.states[s].name);
    rows.text(":");
    list(masks[s].on, " on");
    list(masks[s].off, " off");
    rows.text("\n");
  }
  return rows.text("   ").take();
}

/// The effect of the operations on a moving device, in words.
std::string_view actuation_text(tables::Actuation actuation) {
  switch (actuation) {
    case tables::Actuation::latched:
      return "a started transition continues to its end";
    case tables::Actuation::bistable:
      return "a transition continues without a command and reverses on the opposite one";
    case tables::Actuation::held:
      return "it moves while its operation is on";
    case tables::Actuation::spring:
      return "a spring returns it to rest when no operation is on";
  }
  return "";
}

/// Adds the operations or events of a type: enumerators, each with the symbol of the example device.
std::vector<std::string> add_side(View& view, const std::string& list, const std::vector<std::uint32_t>& side,
                                  const model::PlantModel& plant) {
  text::IdentifierScope scope;
  std::vector<std::string> enumerators;
  auto& items = view.lists[list];
  for (const std::uint32_t index : side) {
    const model::Symbol& symbol = plant.symbols[index];
    enumerators.push_back(scope.unique(symbol.reading.task, "k"));
    std::string address(symbol.written_address());
    if (!symbol.row->vendor_address.empty() && !symbol.row->iec_address.empty()) {
      address.append(" ").append(symbol.row->iec_address);
    }
    View item;
    item.texts["enumerator"] = enumerators.back();
    item.texts["symbol"] = comment_text(symbol.name());
    item.texts["address"] = address.empty() ? "no address" : comment_text(address);
    item.texts["cite"] = comment_text(fmt::format("{}:{}", plant.list_of(symbol).name(), symbol.row->line));
    items.push_back(std::move(item));
  }
  return enumerators;
}

std::string meaning(const model::Unit& unit, const model::State& state) {
  std::string text;
  if (state.operation != kNone) text += fmt::format("commanded by O_{}", state.name);
  if (state.event != kNone) text += fmt::format("{}reported by I_{}", text.empty() ? "" : ", ", state.name);
  if (text.empty()) text = "added: neither commanded nor reported";
  const auto position = static_cast<std::uint32_t>(&state - unit.states.data());
  if (unit.actuation == tables::Actuation::spring && unit.rest == position) text += ", the spring's rest";
  return comment_text(text);
}

std::vector<std::string> add_states(View& view, const model::Unit& unit) {
  text::IdentifierScope scope;
  std::vector<std::string> enumerators;
  auto& items = view.lists["states"];
  for (const model::State& state : unit.states) {
    enumerators.push_back(scope.unique(state.name, "k"));
    View item;
    item.texts["enumerator"] = enumerators.back();
    item.texts["meaning"] = meaning(unit, state);
    items.push_back(std::move(item));
  }
  return enumerators;
}

std::string state_number(std::uint8_t state) {
  return state == tables::kNoState ? "symplant::tables::kNoState" : std::to_string(state);
}

/// Adds what a behavior reads and sets beyond states, operations and events.
void add_behaviour(View& view, const model::Unit& unit, const model::PlantModel& plant) {
  View own;
  own.texts["behaviour"] = text::identifier(unit.described->behaviour);
  text::IdentifierScope scope;
  auto& inputs = own.lists["inputs"];
  for (std::size_t i = 0; i < unit.input_names.size(); ++i) {
    View item;
    item.texts["enumerator"] = scope.unique(unit.input_names[i], "k");
    item.texts["meaning"] = comment_text(short_condition_text(unit.conditions[unit.first_input + i], plant));
    inputs.push_back(std::move(item));
  }
  add_side(own, "values", unit.values, plant);
  std::vector<std::string> kinds;
  for (const std::uint32_t index : unit.values) {
    const model::Symbol& symbol = plant.symbols[index];
    kinds.push_back(fmt::format("{{symplant::tables::DataType::{}, symplant::tables::Direction::{}}}",
                                data_type_name(symbol.type), direction_name(symbol.direction)));
  }
  own.texts["value_count"] = std::to_string(kinds.size());
  own.texts["value_kinds"] = joined(kinds);
  view.lists["behaviour_views"].push_back(std::move(own));
}

View type_view(const lower::Type& type, const std::string& class_name, const model::PlantModel& plant) {
  const model::Unit& unit = plant.units[type.example];
  View view;
  auto& texts = view.texts;
  texts["class"] = class_name;
  texts["title"] = comment_text(fmt::format("{}: {} operation{}, {} event{}, {} states; {}.", class_name,
                                            type.operations, type.operations == 1 ? "" : "s", type.events,
                                            type.events == 1 ? "" : "s", type.states, actuation_text(unit.actuation)));
  texts["operation_list"] = joined(add_side(view, "operations", unit.operations, plant), "Operation::");
  texts["event_list"] = joined(add_side(view, "events", unit.events, plant), "Event::");
  texts["state_list"] = joined(add_states(view, unit), "State::");
  texts["operation_count"] = std::to_string(type.operations);
  texts["event_count"] = std::to_string(type.events);
  texts["state_count"] = std::to_string(type.states);
  texts["transition_count"] = std::to_string(type.transitions.size());
  texts["transition_rows"] = transition_rows(type, unit, plant);
  texts["rest"] = state_number(type.rest);
  texts["actuation"] = description::actuation_name(unit.actuation);
  texts["enter_rows"] = unit.outputs.empty() ? masks_in_line(type.enter) : mask_rows(type.enter, unit, plant);
  texts["leave_rows"] = unit.outputs.empty() ? masks_in_line(type.leave) : mask_rows(type.leave, unit, plant);
  std::vector<std::string> targets;
  for (const std::uint8_t target : type.operation_targets) targets.push_back(state_number(target));
  texts["target_list"] = joined(targets);
  view.lists["behaviour_views"];  // a template needs the list even if it is empty
  if (unit.has_behaviour()) add_behaviour(view, unit, plant);
  return view;
}

std::string without_digits(std::string_view device) {
  std::string word;
  for (const char c : device) {
    if (c < '0' || c > '9') word += c;
  }
  return word.empty() ? "Type" : word;
}

}  // namespace

std::vector<View> device_lines(const std::vector<std::uint32_t>& units, const model::PlantModel& plant) {
  std::vector<View> lines;
  const auto add = [&](std::string text) { lines.push_back({{{"device", std::move(text)}}, {}}); };
  for (std::size_t i = 0; i < units.size() && i < kDevicesShown; ++i) add(comment_text(plant.units[units[i]].path));
  if (units.size() > kDevicesShown) add(fmt::format("and {} more", units.size() - kDevicesShown));
  return lines;
}

std::vector<std::string> class_names(const lower::EngineTables& tables, const model::PlantModel& plant) {
  text::IdentifierScope scope(text::kGeneratedNames);
  std::vector<std::string> names(tables.types.size());
  std::set<std::string> own;                          // names of the user's classes, which are taken
  enum class Source { derived_from, given, device };  // base classes of the user's code get their names first
  const auto source_of = [](const model::Unit& unit) {
    if (unit.described == nullptr || unit.described->type.empty()) return Source::device;
    return unit.has_behaviour() ? Source::derived_from : Source::given;
  };
  for (const model::Unit& unit : plant.units) {
    if (unit.has_behaviour()) own.insert(text::identifier(unit.described->behaviour));
  }
  for (const std::string& name : own) scope.unique(name);
  for (const Source source : {Source::derived_from, Source::given, Source::device}) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const model::Unit& unit = plant.units[tables.types[i].example];
      if (source_of(unit) != source) continue;
      names[i] = scope.unique(source == Source::device ? without_digits(unit.device) : unit.described->type);
    }
  }
  return names;
}

std::vector<View> type_views(const lower::EngineTables& tables, const model::PlantModel& plant,
                             const std::vector<std::string>& classes) {
  std::vector<View> views;
  views.reserve(tables.types.size());
  for (std::size_t i = 0; i < tables.types.size(); ++i) views.push_back(type_view(tables.types[i], classes[i], plant));

  std::vector<std::vector<std::uint32_t>> devices(tables.types.size());
  for (std::uint32_t u = 0; u < tables.units.size(); ++u) devices[tables.units[u].type].push_back(u);
  for (std::size_t i = 0; i < views.size(); ++i) views[i].lists["devices"] = device_lines(devices[i], plant);
  return views;
}

}  // namespace symplant::emit

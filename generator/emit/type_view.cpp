// The views of device types, for their classes.
#include "emit/type_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "emit/encode.hpp"
#include "emit/model_text.hpp"
#include "emit/rows.hpp"
#include "emit/transition_views.hpp"
#include "text/ascii.hpp"
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

/// `on(Event::I_P1) | off(Event::I_P2)`; empty if no event is switched.
std::string masks_text(const tables::EventMasks& masks, const std::vector<std::string>& events) {
  const auto set = [&](std::uint64_t bits, const char* function) {
    std::vector<std::string> names;
    for (std::size_t e = 0; e < events.size(); ++e) {
      if (((bits >> e) & 1U) != 0) names.push_back(events[e]);
    }
    return names.empty() ? "" : fmt::format("{}({})", function, joined(names, "Event::"));
  };
  const std::string on = set(masks.on, "on");
  const std::string off = set(masks.off, "off");
  return on + (on.empty() || off.empty() ? "" : " | ") + off;
}

/// A list of the events of a mask, for templates.
std::vector<View> events_of(std::uint64_t bits, const std::vector<std::string>& events) {
  std::vector<View> items;
  for (std::size_t e = 0; e < events.size(); ++e) {
    if (((bits >> e) & 1U) != 0) items.push_back({{{"event", events[e]}}, {}});
  }
  return items;
}

/// Adds what entering and leaving each state switches.
void add_masks(View& view, const lower::Type& type, const Enumerators& names) {
  std::vector<View>& states = view.lists["states"];
  for (const char* list : {"enters", "entered", "leaves", "left"}) view.lists[list];
  for (std::size_t s = 0; s < states.size(); ++s) {
    states[s].lists["enter_on"] = events_of(type.enter[s].on, names.events);
    states[s].lists["enter_off"] = events_of(type.enter[s].off, names.events);
    states[s].lists["leave_on"] = events_of(type.leave[s].on, names.events);
    states[s].lists["leave_off"] = events_of(type.leave[s].off, names.events);
    const auto add = [&](const char* list, const tables::EventMasks& masks) {
      std::string text = masks_text(masks, names.events);
      if (!text.empty()) view.lists[list].push_back({{{"state", names.states[s]}, {"events", std::move(text)}}, {}});
    };
    add("entered", type.enter[s]);
    add("left", type.leave[s]);
  }
  if (!view.lists["entered"].empty()) view.lists["enters"].emplace_back();
  if (!view.lists["left"].empty()) view.lists["leaves"].emplace_back();
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

/// Adds symbols of a type: enumerators by direction and task, each with the symbol of the example device.
std::vector<std::string> add_side(View& view, const std::string& list, std::span<const std::uint32_t> side,
                                  const model::PlantModel& plant) {
  text::IdentifierScope scope;
  std::vector<std::string> enumerators;
  auto& items = view.lists[list];
  for (const std::uint32_t index : side) {
    const model::Symbol& symbol = plant.symbols[index];
    const bool operation = symbol.direction == tables::Direction::operation;
    enumerators.push_back(scope.unique(symbol.reading.task(), operation ? "O_" : "I_"));
    std::string address(symbol.written_address());
    if (!symbol.row->vendor_address.empty() && !symbol.row->iec_address.empty()) {
      address.append(" ").append(symbol.row->iec_address);
    }
    View item;
    item.texts["enumerator"] = enumerators.back();
    item.texts["number"] = std::to_string(items.size());
    item.texts["task"] = comment_text(symbol.reading.task());
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
    enumerators.push_back(scope.unique(state.name));
    View item;
    item.texts["enumerator"] = enumerators.back();
    item.texts["number"] = std::to_string(items.size());
    item.texts["name"] = comment_text(state.name);
    item.texts["meaning"] = meaning(unit, state);
    items.push_back(std::move(item));
  }
  return enumerators;
}

std::string state_text(std::uint8_t state, const Enumerators& names) {
  return state == tables::kNoState ? "State{kNoState}" : "State::" + names.states[state];
}

/// Adds what a behavior reads and sets beyond states, operations and events.
void add_behaviour(View& view, const model::Unit& unit, const model::PlantModel& plant) {
  View own;
  own.texts["behaviour"] = text::identifier(unit.described->behaviour);
  text::IdentifierScope scope;
  auto& inputs = own.lists["inputs"];
  for (std::size_t i = 0; i < unit.input_names.size(); ++i) {
    View item;
    item.texts["enumerator"] = scope.unique(unit.input_names[i]);
    item.texts["meaning"] = comment_text(short_condition_text(unit.conditions[unit.first_input + i], plant));
    inputs.push_back(std::move(item));
  }
  add_side(own, "values", unit.behaviour_values(), plant);
  std::vector<std::string> kinds;
  for (const std::uint32_t index : unit.behaviour_values()) {
    const model::Symbol& symbol = plant.symbols[index];
    kinds.push_back(fmt::format("{{symplant::tables::DataType::{}, symplant::tables::Direction::{}}}",
                                data_type_name(symbol.type), direction_name(symbol.direction)));
  }
  own.texts["value_count"] = std::to_string(kinds.size());
  own.texts["value_kinds"] = joined(kinds);
  view.lists["behaviour_views"].push_back(std::move(own));
}

View type_view(const lower::Type& type, const std::string& class_name, const std::vector<std::uint32_t>& devices,
               const lower::EngineTables& tables, const model::PlantModel& plant) {
  const model::Unit& unit = plant.units[type.example];
  View view;
  auto& texts = view.texts;
  texts["class"] = class_name;
  texts["title"] = comment_text(fmt::format("{}: {} operation{}, {} event{}, {} states; {}.", class_name,
                                            type.operations, type.operations == 1 ? "" : "s", type.events,
                                            type.events == 1 ? "" : "s", type.states, actuation_text(unit.actuation)));
  const Enumerators names{add_side(view, "operations", unit.operations, plant),
                          add_side(view, "events", unit.events, plant), add_states(view, unit)};
  texts["operation_list"] = joined(names.operations, "Operation::");
  texts["event_list"] = joined(names.events, "Event::");
  texts["state_list"] = joined(names.states, "State::");
  texts["operation_count"] = std::to_string(type.operations);
  texts["event_count"] = std::to_string(type.events);
  texts["state_count"] = std::to_string(type.states);
  texts["device_count"] = std::to_string(devices.size());
  texts["initial"] = std::to_string(unit.initial);
  texts["rest"] = state_text(type.rest, names);
  texts["actuation"] = description::actuation_name(unit.actuation);
  std::vector<std::string> targets;
  for (const std::uint8_t target : type.operation_targets) targets.push_back(state_text(target, names));
  texts["target_list"] = joined(targets);
  add_transitions(view, type, names, devices, tables, plant);
  add_masks(view, type, names);
  view.lists["devices"] = device_lines(devices, plant);
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

/// The device level, and the archetype of the facet: `RBT_Work`.
std::string class_stem(const model::Unit& unit, const model::PlantModel& plant) {
  std::string stem = without_digits(unit.device);
  if (!unit.is_archetype()) return stem;
  std::string archetype = plant.naming().archetypes[unit.facet->archetype].name;
  if (!archetype.empty()) archetype.front() = text::upper(archetype.front());
  return stem.append("_").append(archetype);
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
  enum class Source { derived_from, given, device };  // base classes of the user's code get their names first
  struct Wanted {
    Source source{};
    std::string name;
    std::vector<std::string> tasks;  // what the types of one name differ in, whatever the order of rows
    std::string device;              // the path of its first device by name
    std::uint32_t unit = 0;          // that device
    std::size_t type = 0;
  };
  std::vector<Wanted> wanted(tables.types.size());
  for (std::uint32_t u = 0; u < tables.units.size(); ++u) {
    std::string& device = wanted[tables.units[u].type].device;
    const std::string_view path = plant.units[u].path;
    const auto before = [](char c, char upper) {
      return static_cast<unsigned char>(text::upper(c)) < static_cast<unsigned char>(upper);
    };
    if (!device.empty() &&
        !std::lexicographical_compare(path.begin(), path.end(), device.begin(), device.end(), before)) {
      continue;
    }
    device = text::to_upper(path);
    wanted[tables.units[u].type].unit = u;
  }
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const model::Unit& unit = plant.units[tables.types[i].example];
    const bool given = unit.described != nullptr && !unit.described->type.empty();
    wanted[i].source = !given ? Source::device : unit.has_behaviour() ? Source::derived_from : Source::given;
    wanted[i].name = given ? unit.described->type : class_stem(plant.units[wanted[i].unit], plant);
    wanted[i].type = i;
    for (const std::uint32_t symbol : unit.operations) {
      wanted[i].tasks.push_back("O_" + text::to_upper(plant.symbols[symbol].reading.task()));
    }
    for (const std::uint32_t symbol : unit.events) {
      wanted[i].tasks.push_back("I_" + text::to_upper(plant.symbols[symbol].reading.task()));
    }
    std::sort(wanted[i].tasks.begin(), wanted[i].tasks.end());
  }
  std::sort(wanted.begin(), wanted.end(), [](const Wanted& a, const Wanted& b) {
    return std::tie(a.source, a.name, a.tasks, a.device) < std::tie(b.source, b.name, b.tasks, b.device);
  });

  text::IdentifierScope scope(text::kGeneratedNames);
  std::set<std::string> own;  // names of the user's classes, which are taken
  for (const model::Unit& unit : plant.units) {
    if (unit.has_behaviour()) own.insert(text::identifier(unit.described->behaviour));
  }
  for (const std::string& name : own) scope.unique(name);
  std::vector<std::string> names(wanted.size());
  for (const Wanted& type : wanted) names[type.type] = scope.unique(type.name);
  return names;
}

std::vector<View> type_views(const lower::EngineTables& tables, const model::PlantModel& plant,
                             const std::vector<std::string>& classes) {
  std::vector<std::vector<std::uint32_t>> devices(tables.types.size());
  for (std::uint32_t u = 0; u < tables.units.size(); ++u) devices[tables.units[u].type].push_back(u);
  std::vector<View> views;
  views.reserve(tables.types.size());
  for (std::size_t i = 0; i < tables.types.size(); ++i) {
    views.push_back(type_view(tables.types[i], classes[i], devices[i], tables, plant));
  }
  return views;
}

}  // namespace symplant::emit

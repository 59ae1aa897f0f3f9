// A device type as its class shows it.
#include "emit/type_view.hpp"

#include <fmt/format.h>

#include <array>

#include "base/identifier.hpp"
#include "emit/encode.hpp"
#include "emit/row_writer.hpp"
#include "emit/rows.hpp"

namespace symplant::emit {
namespace {

using model::kNone;

/// Names that a class must not have: those that the generated files themselves use.
constexpr auto kTaken = std::to_array<std::string_view>({"Plant",
                                                         "Device",
                                                         "Symbol",
                                                         "Operation",
                                                         "Event",
                                                         "State",
                                                         "core",
                                                         "tables",
                                                         "symplant",
                                                         "std",
                                                         "main",
                                                         "make_plant",
                                                         "row",
                                                         "OwnedPlant",
                                                         "d_ext",
                                                         "d_int",
                                                         "l_enter",
                                                         "l_leave",
                                                         "l_disable",
                                                         "kI",
                                                         "kO",
                                                         "kS",
                                                         "kEnter",
                                                         "kLeave",
                                                         "kTargets",
                                                         "kTransitions",
                                                         "kTypes",
                                                         "kUnits",
                                                         "kTimes",
                                                         "kRandomTimes",
                                                         "kSymbols",
                                                         "kTables",
                                                         "kFree",
                                                         "kInitialValues",
                                                         "kSharedAddresses",
                                                         "kDisables",
                                                         "kConditions",
                                                         "kConditionedUnits",
                                                         "kUnitWatches",
                                                         "kOperationWatches",
                                                         "kEventWatches",
                                                         "kOperationValueWatches",
                                                         "kEventValueWatches",
                                                         "kRequirements",
                                                         "kBehaviourUnits",
                                                         "kBehaviourValues",
                                                         "kUnitNames",
                                                         "kStateNames",
                                                         "kSymbolNames",
                                                         "kRequirementNames",
                                                         "kBehaviourNames"});
constexpr std::size_t kDevicesShown = 20;

std::string joined(const std::vector<std::string>& parts, std::string_view prefix = "") {
  std::string out;
  for (const std::string& part : parts) out.append(out.empty() ? "" : ", ").append(prefix).append(part);
  return out;
}

/// Where each state switches its own event alone: in one line.
std::string masks_in_line(const std::vector<core::EventMasks>& masks) {
  std::vector<std::string> parts;
  parts.reserve(masks.size());
  for (const core::EventMasks& row : masks) parts.push_back(fmt::format("{{{:#x}, {:#x}}}", row.on, row.off));
  return joined(parts);
}

/// Of each state the events that entering or leaving it switches, a row each with the events' names.
std::string mask_rows(const std::vector<core::EventMasks>& masks, const model::Unit& unit,
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

/// What a move does while its operations change, in words.
std::string_view actuation_text(core::Actuation actuation) {
  switch (actuation) {
    case core::Actuation::latched:
      return "a move once started goes on to its end";
    case core::Actuation::bistable:
      return "a move goes on without a command and turns round on the other one";
    case core::Actuation::held:
      return "it moves as long as its operation is on";
    case core::Actuation::spring:
      return "a spring returns it to rest when no operation is on";
  }
  return "";
}

/// One side of a type: its enumerators, each with the example's symbol.
std::vector<std::string> add_side(View& view, const std::string& list, const std::vector<std::uint32_t>& side,
                                  const model::PlantModel& plant) {
  base::IdentifierScope scope;
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
  const auto place = static_cast<std::uint32_t>(&state - unit.states.data());
  if (unit.actuation == core::Actuation::spring && unit.rest == place) text += ", the spring's rest";
  return comment_text(text);
}

std::vector<std::string> add_states(View& view, const model::Unit& unit) {
  base::IdentifierScope scope;
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
  return state == core::kNoState ? "symplant::core::kNoState" : std::to_string(state);
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
  texts["actuation"] = model::actuation_name(unit.actuation);
  texts["enter_rows"] = unit.outputs.empty() ? masks_in_line(type.enter) : mask_rows(type.enter, unit, plant);
  texts["leave_rows"] = unit.outputs.empty() ? masks_in_line(type.leave) : mask_rows(type.leave, unit, plant);
  std::vector<std::string> targets;
  for (const std::uint8_t target : type.operation_targets) targets.push_back(state_number(target));
  texts["target_list"] = joined(targets);
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

std::vector<std::string> class_names(const lower::EngineTables& tables, const model::PlantModel& plant) {
  base::IdentifierScope scope(kTaken);
  std::vector<std::string> names(tables.types.size());
  const auto name_types = [&](bool given) {  // what the user says comes before what a device is called
    for (std::size_t i = 0; i < names.size(); ++i) {
      const model::Unit& unit = plant.units[tables.types[i].example];
      const bool is_given = unit.described != nullptr && !unit.described->type.empty();
      if (is_given == given) names[i] = scope.unique(given ? unit.described->type : without_digits(unit.device));
    }
  };
  name_types(true);
  name_types(false);
  return names;
}

std::vector<View> type_views(const lower::EngineTables& tables, const model::PlantModel& plant,
                             const std::vector<std::string>& classes) {
  std::vector<View> views;
  views.reserve(tables.types.size());
  for (std::size_t i = 0; i < tables.types.size(); ++i) views.push_back(type_view(tables.types[i], classes[i], plant));

  std::vector<std::size_t> counts(tables.types.size());
  for (std::size_t u = 0; u < tables.units.size(); ++u) {
    const std::uint32_t type = tables.units[u].type;
    if (++counts[type] > kDevicesShown) continue;
    View device;
    device.texts["device"] = comment_text(plant.units[u].path);
    views[type].lists["devices"].push_back(std::move(device));
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] <= kDevicesShown) continue;
    View more;
    more.texts["device"] = fmt::format("and {} more", counts[i] - kDevicesShown);
    views[i].lists["devices"].push_back(std::move(more));
  }
  return views;
}

}  // namespace symplant::emit

// The model of a device as items that can be compared one by one.
#include "diff/items.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "description/description.hpp"
#include "elements/follow/words.hpp"
#include "elements/malfunction/words.hpp"
#include "elements/material/words.hpp"
#include "elements/requirement/words.hpp"
#include "elements/value/words.hpp"
#include "model/condition_text.hpp"
#include "view/words.hpp"

namespace symplant::diff {
namespace {

constexpr std::string_view kOperation = "operation";
constexpr std::string_view kEvent = "event";
constexpr std::string_view kState = "state";
constexpr std::string_view kEntering = "on entering";
constexpr std::string_view kLeaving = "on leaving";

/// Joins texts with ", ".
void append_part(std::string& text, std::string_view part) {
  if (part.empty()) return;
  text.append(text.empty() ? "" : ", ").append(part);
}

class UnitItems {
 public:
  UnitItems(const model::PlantModel& plant, const model::Unit& unit) : plant_(plant), unit_(unit) {}

  std::vector<Item> take() {
    add_head();
    for (std::uint32_t i = 0; i < unit_.operations.size(); ++i) {
      items_.push_back({kOperation, view::operation_text(plant_, unit_, i), ""});
    }
    for (std::uint32_t i = 0; i < unit_.events.size(); ++i) {
      items_.push_back({kEvent, view::event_text(plant_, unit_, i), ""});
    }
    for (const model::State& state : unit_.states) items_.push_back({kState, state.name, symbols_of(state)});
    for (const model::Transition& t : unit_.transitions) add_transition("transition", t);
    for (const model::Transition& t : view::spring_returns(unit_)) add_transition("spring return", t);
    for (std::uint32_t s = 0; s < unit_.states.size(); ++s) {
      add_outputs(kEntering, s, true);
      add_outputs(kLeaving, s, false);
    }
    add_disables();
    if (unit_.has_behaviour()) add_behaviour();
    return std::move(items_);
  }

 private:
  const std::string& state(std::uint32_t index) const { return unit_.states[index].name; }

  void add_head() {
    items_.push_back({"actuation", "", std::string(description::actuation_name(unit_.actuation))});
    items_.push_back({"travel time", "", view::time_text(unit_.travel)});
    if (unit_.overrun != tables::kNever) items_.push_back({"overrun", "", view::time_text(unit_.overrun)});
    items_.push_back({"initial state", "", state(unit_.initial)});
    if (unit_.rest != kNone) items_.push_back({"rest state", "", state(unit_.rest)});
  }

  std::string symbols_of(const model::State& of) const {
    std::string text;
    if (of.operation != kNone) append_part(text, view::operation_text(plant_, unit_, of.operation));
    if (of.event != kNone) append_part(text, view::event_text(plant_, unit_, of.event));
    return text;
  }

  void add_transition(std::string_view element, const model::Transition& t) {
    const view::TransitionText words = view::transition_text(t, unit_, plant_);
    std::string value;
    append_part(value, words.when.empty() ? "" : "when " + words.when);
    append_part(value, words.after);
    append_part(value, words.takes);
    append_part(value, words.during.empty() ? "" : "while " + words.during);
    append_part(value, words.numbers);
    items_.push_back({element,
                      fmt::format("({}, {}) -> {}", state(t.from), words.on, state(t.to)),
                      std::move(value),
                      {state(t.from), state(t.to)}});
  }

  void add_outputs(std::string_view element, std::uint32_t s, bool entering) {
    std::string text;
    for (const auto& [event, on] : view::switched(unit_, s, entering)) {
      append_part(text, view::event_text(plant_, unit_, event) + (on ? " on" : " off"));
    }
    if (!text.empty()) items_.push_back({element, state(s), std::move(text), {state(s)}});
  }

  void add_disables() {
    for (std::uint32_t s = 0; s < unit_.disables.size(); ++s) {
      for (const std::uint32_t other : unit_.disables[s]) {
        items_.push_back({"disables", fmt::format("{} in {}", plant_.units[other].path, state(s)), "", {state(s)}});
      }
    }
  }

  void add_behaviour() {
    items_.push_back({"behavior", "", unit_.described->behaviour});
    for (std::size_t i = unit_.first_input; i < unit_.conditions.size(); ++i) {
      items_.push_back({"input", std::string(unit_.input_names[i - unit_.first_input]),
                        model::condition_text(unit_.conditions[i], plant_)});
    }
    for (const std::uint32_t value : unit_.values) {
      items_.push_back({"value", std::string(plant_.symbols[value].name()), ""});
    }
  }

  const model::PlantModel& plant_;
  const model::Unit& unit_;
  std::vector<Item> items_;
};

void add_material(const model::PlantModel& plant, std::vector<Item>& items) {
  std::string owner;  // of the indented lines
  for (const std::string& line : view::material_lines(plant)) {
    if (line.starts_with("  ")) {
      items.push_back({"material", owner + ": " + line.substr(2), ""});
      continue;
    }
    owner = line.substr(0, line.find(": "));
    const std::size_t begin = std::min(line.size(), owner.size() + 2);
    items.push_back({"material", owner, line.substr(begin)});
  }
}

using NthKey = std::tuple<std::string_view, std::string_view, std::size_t>;

/// Each item by element, key, and its number among those of equal element and key.
std::vector<NthKey> numbered(const std::vector<Item>& items) {
  std::map<std::pair<std::string_view, std::string_view>, std::size_t> counts;
  std::vector<NthKey> keys;
  keys.reserve(items.size());
  for (const Item& item : items) keys.emplace_back(item.element, item.key, counts[{item.element, item.key}]++);
  return keys;
}

/// The parts of `O_P2, I_P2`.
std::set<std::string> parts_of(const std::string& text) {
  std::set<std::string> parts;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(", ", begin), text.size());
    parts.insert(text.substr(begin, end - begin));
    begin = end + 2;
  }
  return parts;
}

/// Finds the changes that follow from states that came, went, or have other symbols: operations, events, transitions
/// and outputs.
class Consequences {
 public:
  void add_state(const ItemChange& change) {
    if (change.element != kState) return;
    (change.before && change.after ? changed_ : states_).insert(change.key);
    const std::set<std::string> was = parts_of(change.before.value_or(""));
    const std::set<std::string> is = parts_of(change.after.value_or(""));
    std::set_symmetric_difference(was.begin(), was.end(), is.begin(), is.end(), std::inserter(tasks_, tasks_.end()));
  }

  bool contain(const ItemChange& change, const Item& item) const {
    if (change.element == kOperation || change.element == kEvent) return tasks_.count(change.key) != 0;
    if (change.element == kEntering || change.element == kLeaving) {
      return states_.count(change.key) + changed_.count(change.key) != 0;
    }
    return states_.count(item.states[0]) != 0 || states_.count(item.states[1]) != 0;
  }

 private:
  std::set<std::string> states_;   ///< gained or lost
  std::set<std::string> changed_;  ///< with other symbols
  std::set<std::string> tasks_;    ///< gained or lost by a state
};

}  // namespace

std::vector<Item> items_of(const model::PlantModel& plant, const model::Unit& unit) {
  return UnitItems(plant, unit).take();
}

std::vector<Item> plant_items(const model::PlantModel& plant) {
  std::vector<Item> items;
  if (plant.description_source != nullptr) items.push_back({"plant", "name", plant.name});
  for (const model::Requirement& requirement : plant.requirements) {
    items.push_back({"requirement", requirement.name, view::requirement_text(requirement, plant)});
  }
  for (const model::Follow& follow : plant.follows) {
    items.push_back({"follows", std::string(plant.symbols[follow.symbol].name()), view::follow_text(follow, plant)});
  }
  for (const model::Value& value : plant.values) {
    items.push_back({"value", value.name, view::value_line(value, plant)});
  }
  for (const model::Signal& signal : plant.signals) {
    items.push_back({"signal", std::string(plant.symbols[signal.row.symbol].name()), view::signal_line(signal, plant)});
  }
  add_material(plant, items);
  for (const model::Malfunction& malfunction : plant.malfunctions) {
    items.push_back({"malfunction", malfunction.name, view::malfunction_text(malfunction, plant)});
  }
  return items;
}

std::vector<ItemChange> item_changes(const std::vector<Item>& before, const std::vector<Item>& after) {
  if (before == after) return {};
  const std::vector<NthKey> old_keys = numbered(before);
  const std::vector<NthKey> new_keys = numbered(after);
  std::map<NthKey, std::size_t> olds;
  for (std::size_t i = 0; i < before.size(); ++i) olds.emplace(old_keys[i], i);
  std::vector<ItemChange> changes;
  std::vector<const Item*> items;
  const auto add = [&](const Item& item, std::optional<std::string> was, std::optional<std::string> is) {
    changes.push_back({std::string(item.element), item.key, std::move(was), std::move(is)});
    items.push_back(&item);
  };
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto old = olds.find(new_keys[i]);
    if (old == olds.end()) {
      add(after[i], std::nullopt, after[i].value);
      continue;
    }
    if (before[old->second].value != after[i].value) add(after[i], before[old->second].value, after[i].value);
    olds.erase(old);
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (olds.count(old_keys[i]) != 0) add(before[i], before[i].value, std::nullopt);
  }
  Consequences consequences;
  for (const ItemChange& change : changes) consequences.add_state(change);
  for (std::size_t i = 0; i < changes.size(); ++i) changes[i].follows = consequences.contain(changes[i], *items[i]);
  return changes;
}

}  // namespace symplant::diff

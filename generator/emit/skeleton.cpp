// Writes a first plant description. A commented-out key ends in a comma and is always followed by an active key.
#include "emit/skeleton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "elements/alarm/skeleton.hpp"
#include "elements/material/skeleton.hpp"
#include "elements/value/skeleton.hpp"
#include "emit/shapes.hpp"
#include "model/condition_text.hpp"

namespace symplant::emit {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostNames = 6;    ///< names listed in a comment; the others are counted
constexpr std::size_t kMostSamples = 6;  ///< transitions in a line

/// A text as a JSON string. It contains no line end, so it is also safe after `//`.
std::string json_text(std::string_view text) { return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string one_line(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string spaced;  // with a space after each colon and comma outside strings
  bool in_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    spaced += text[i];
    if (in_text && text[i] == '\\') {
      spaced += text[++i];
    } else if (text[i] == '"') {
      in_text = !in_text;
    } else if (!in_text && (text[i] == ':' || text[i] == ',')) {
      spaced += ' ';
    }
  }
  return spaced;
}

std::string seconds(tables::Time time) {
  return time % tables::kSecond == 0 ? fmt::format("{}s", time / tables::kSecond) : fmt::format("{}ns", time);
}

/// "A, B, C and 4 more"
std::string some_of(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kMostNames; ++i) text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > kMostNames) text += fmt::format(" and {} more", names.size() - kMostNames);
  return text;
}

class Skeleton {
 public:
  Skeleton(const model::PlantModel& plant, const model::Evidence& evidence, const SkeletonList& list)
      : plant_(plant),
        evidence_(evidence),
        list_(list),
        shapes_(shapes_of(plant)),
        proposed_(proposed_material(plant)) {
    // Nothing is known of a device whose symbols name no state.
    std::erase_if(shapes_, [this](const Shape& shape) { return plant_.units[shape.units.front()].names_no_state(); });
    if (!proposed_.is_null()) leave_out_sensors();
  }

  std::string write() {
    head();
    line("{");
    line("  \"symplant\": 1,");
    line("  \"name\": " + json_text(plant_.name) + ",");
    line("  // Defaults for all devices:");
    line(
        "  // \"defaults\": { \"travel\": \"1s\", \"dwell\": \"1s\", \"actuation\": \"latched\", \"sequence\": "
        "\"free\" },");
    material();
    values();
    requirements();
    malfunctions();
    alarms();
    links();
    check_section();
    line("  \"symbols\": [" + list_reference() + "],");
    if (!list_.naming.empty()) line("  \"naming\": " + json_text(list_.naming) + ",");
    event_not_driven();
    line("  \"devices\": {");
    for (std::size_t i = 0; i < shapes_.size(); ++i) device(shapes_[i], i + 1 == shapes_.size());
    line("  }");
    line("}");
    return std::move(text_);
  }

 private:
  void line(std::string_view text) { text_.append(text).append("\n"); }
  void head() {
    line(fmt::format("// A plant description, written by `symplant init`: {} device{} of {} shape{}.",
                     plant_.units.size(), plant_.units.size() == 1 ? "" : "s", shapes_.size(),
                     shapes_.size() == 1 ? "" : "s"));
    line("// It states only what symplant infers from the list anyway. To state more, remove the `//` before a key");
    line("// and change its value: each of these lines is valid as it is, alone or with the others.");
  }

  /// Devices that the proposed material takes all symbols of: their entries would be errors with it.
  void leave_out_sensors() {
    std::erase_if(shapes_, [this](const Shape& shape) {
      return std::any_of(shape.named.begin(), shape.named.end(),
                         [this](std::uint32_t unit) { return is_only_part_sensors(plant_, plant_.units[unit]); });
    });
  }

  void material() {
    if (proposed_.is_null()) return;
    line(
        "  // Parts on tracks: these inputs look like sensors of parts. Fill in lengths, positions and what drives "
        "them:");
    line("  // \"material\": " + one_line(proposed_) + ",");
  }

  /// One line: a signal is an error without its value.
  void values() {
    std::size_t left_out = 0;
    const Json proposed = proposed_values(plant_, left_out);
    if (proposed.is_null()) return;
    line(fmt::format("  // These inputs are numbers: values with formulas give them theirs{}. Fill the formulas in:",
                     left_out == 0 ? "" : fmt::format(" ({} more without an entry)", left_out)));
    line("  // \"values\": " + one_line(proposed["values"]) + ", \"signals\": " + one_line(proposed["signals"]) + ",");
  }

  std::string list_reference() const {
    if (list_.format.empty() && list_.encoding.empty() && list_.xy.empty()) return json_text(list_.file);
    Json list{{"file", list_.file}};
    if (!list_.format.empty()) list["format"] = list_.format;
    if (!list_.encoding.empty()) list["encoding"] = list_.encoding;
    if (!list_.xy.empty()) list["xy"] = list_.xy;
    return one_line(list);
  }

  /// A unit with a state that has both an operation and an event, and is not the initial state.
  struct Commanded {
    std::uint32_t unit;
    std::uint8_t state;
  };
  std::vector<Commanded> commanded() const {
    std::vector<Commanded> found;
    for (std::uint32_t u = 0; u < plant_.units.size() && found.size() < 2; ++u) {
      const model::Unit& unit = plant_.units[u];
      for (std::uint32_t s = 0; s < unit.states.size(); ++s) {
        const model::State& state = unit.states[s];
        if (state.operation == model::kNone || state.event == model::kNone || s == unit.initial) continue;
        found.push_back({u, static_cast<std::uint8_t>(s)});
        break;
      }
    }
    return found;
  }

  static condition::Tree atom(condition::Atom::Kind kind, std::uint32_t of, std::uint8_t state) {
    condition::Tree tree;
    tree.kind = condition::Tree::Kind::atom;
    tree.atom.kind = kind;
    tree.atom.of = of;
    tree.atom.state = state;
    return tree;
  }

  /// The pattern of the sample's shape if each of its devices has such an operation, named DEVICE_O_STATE; else empty.
  std::string pattern_of(const Commanded& sample) const {
    const auto is_plain = [&](std::uint32_t u) {
      const model::Unit& unit = plant_.units[u];
      if (unit.facet != nullptr || sample.state >= unit.states.size()) return false;
      const model::State& state = unit.states[sample.state];
      if (state.operation == model::kNone || state.name != plant_.units[sample.unit].states[sample.state].name)
        return false;
      // Without quotes in a condition.
      const condition::Tree command = atom(condition::Atom::Kind::bit, unit.operations[state.operation], 0);
      return model::condition_text(command, plant_) == fmt::format("{}_O_{}", unit.path, state.name);
    };
    for (const Shape& shape : shapes_) {
      if (shape.named.size() < 2 || std::find(shape.named.begin(), shape.named.end(), sample.unit) == shape.named.end())
        continue;
      return std::all_of(shape.named.begin(), shape.named.end(), is_plain) ? shape.pattern : "";
    }
    return {};
  }

  void requirements() {
    const std::vector<Commanded> samples = commanded();
    if (samples.empty()) return;
    const model::Unit& unit = plant_.units[samples[0].unit];
    const std::uint32_t command = unit.operations[unit.states[samples[0].state].operation];
    const condition::Tree reached = atom(condition::Atom::Kind::settled, samples[0].unit, samples[0].state);
    Json list = Json::array();
    if (const std::string pattern = pattern_of(samples[0]); !pattern.empty()) {
      const std::string_view rest = plant_.symbols[command].name().substr(unit.path.size());
      list.push_back({{"name", "{self} answers"},
                      {"for", pattern},
                      {"after", fmt::format("{{self}}{}", rest)},
                      {"expect", fmt::format("{{self}}.{}", unit.states[samples[0].state].name)},
                      {"within", "5s"}});
    } else {
      list.push_back({{"name", fmt::format("{} answers", unit.path)},
                      {"after", model::condition_text(atom(condition::Atom::Kind::bit, command, 0), plant_)},
                      {"expect", model::condition_text(reached, plant_)},
                      {"within", "5s"}});
    }
    if (samples.size() == 2) {
      condition::Tree both;
      both.kind = condition::Tree::Kind::all;
      both.children = {reached, atom(condition::Atom::Kind::settled, samples[1].unit, samples[1].state)};
      list.push_back({{"name", fmt::format("{} and {} apart", unit.path, plant_.units[samples[1].unit].path)},
                      {"never", model::condition_text(both, plant_)}});
    }
    line("  // Requirements on every run of the plant; a violation makes `symplant run` fail:");
    line("  // \"requirements\": " + one_line(list) + ",");
  }

  /// Of a device that moves on a command, so that a malfunction of it shows.
  void malfunctions() {
    const std::vector<Commanded> samples = commanded();
    if (samples.empty()) return;
    const model::Unit& unit = plant_.units[samples[0].unit];
    const Json list{
        {{"name", fmt::format("{} sluggish", unit.path)}, {"of", unit.path}, {"slower", 3}, {"lasts", "1min"}}};
    line(
        "  // Malfunctions that a scenario starts by their names, besides the ordinary ones of each device and input:");
    line("  // \"malfunctions\": " + one_line(list) + ",");
  }

  void alarms() {
    const std::vector<std::string> proposed = proposed_alarms(plant_);
    if (proposed.empty()) return;
    line("  // These operations look like alarms. `symplant campaign` calls a fault detected if one of them comes on:");
    line("  // \"alarms\": " + one_line(Json(proposed)) + ",");
  }

  void links() {
    const bool low = plant_.links.front().link.word_order == link::WordOrder::low_first;
    line("  // How the PLC is linked; `symplant map` shows the address of each symbol:");
    line("  // \"links\": [{\"url\": \"modbus-tcp-server://127.0.0.1:1502\", \"word-order\": \"" +
         std::string(low ? "low-first" : "high-first") + "\", \"on-loss\": \"hold\", \"loss-after\": \"1s\"}],");
  }

  /// Proposes a severity, not an entry of `ignore`: the transitions proposed below would make such an entry idle, and
  /// that is a finding.
  void check_section() {
    const bool idle = std::any_of(plant_.units.begin(), plant_.units.end(), [](const model::Unit& unit) {
      return unit.operations.empty() && !unit.names_no_state();
    });
    if (!idle) return;
    const Json check{{"severity", {{"event-not-driven", "warning"}}}};
    line("  // Severities of the findings of `symplant check`; its key `ignore` suppresses intended findings:");
    line("  // \"check\": " + one_line(check) + ",");
  }

  void event_not_driven() {
    std::vector<std::string> names;
    for (const model::Unit& unit : plant_.units) {
      if (!unit.operations.empty() || unit.names_no_state()) continue;
      if (proposed_.is_null() || !is_only_part_sensors(plant_, unit)) names.push_back(json_text(unit.path));
    }
    if (!names.empty()) {
      line(fmt::format("  // No operation moves {}: give `initial` for their state, or automatic `transitions`;",
                       some_of(names)));
      line("  // scenarios and links can set them, too.");
    }
    std::vector<std::string> symbols;
    for (const model::Symbol& symbol : plant_.symbols) {
      if (symbol.unit_of_device() == model::kNone) symbols.push_back(json_text(symbol.name()));
    }
    if (!symbols.empty()) {
      line(fmt::format("  // In no device, but in the images and on the links: {}.", some_of(symbols)));
    }
  }

  void device(const Shape& shape, bool last) {
    const model::Unit& unit = plant_.units[shape.named.front()];
    line("    // " + inferred(shape, unit));
    const std::string hint = worth_saying(unit, evidence_.units[static_cast<std::size_t>(&unit - plant_.units.data())]);
    if (!hint.empty()) line("    // Worth giving: " + hint);
    line("    " + json_text(shape.pattern) + ": {");
    line("      // \"initial\": " + json_text(unit.states[unit.initial].name) + ",");
    if (unit.is_archetype()) {
      line("      \"only\": true  // the transitions are those of the archetype");
      line(last ? "    }" : "    },");
      return;
    }
    line("      // \"actuation\": " + json_text(description::actuation_name(unit.actuation)) + ",");
    if (unit.actuation == tables::Actuation::spring) {
      line("      // \"rest\": " + json_text(unit.states[unit.rest].name) + ",");
    }
    const Json transitions = transitions_of(unit);
    if (!transitions.empty()) line("      // \"transitions\": " + one_line(transitions) + ",");
    line("      \"only\": false  // true: only the transitions given here exist, none is derived from operations");
    line(last ? "    }" : "    },");
  }

  std::string inferred(const Shape& shape, const model::Unit& unit) const {
    std::vector<std::string> operations;
    std::vector<std::string> events;
    for (const model::State& state : unit.states) {
      if (state.operation != model::kNone) operations.push_back(state.name);
      if (state.event != model::kNone) events.push_back(state.name);
    }
    std::string text =
        fmt::format("{} device{}: operations {}; events {}; {}", shape.units.size(), shape.units.size() == 1 ? "" : "s",
                    operations.empty() ? "none" : some_of(operations), events.empty() ? "none" : some_of(events),
                    description::actuation_name(unit.actuation));
    if (unit.actuation == tables::Actuation::spring) text += " that rests in " + unit.states[unit.rest].name;
    text += fmt::format(", starts in {}", unit.states[unit.initial].name);
    if (shape.named.size() == shape.units.size()) return text;
    std::vector<std::string> others;
    for (const std::uint32_t other : shape.units) {
      const bool named = std::binary_search(shape.named.begin(), shape.named.end(), other);
      if (!named) others.emplace_back(plant_.units[other].path);
    }
    return text + "; of equal structure, but without a common pattern: " + some_of(others);
  }

  /// The state in which an engineer would expect a unit to start that starts in its lowest number (HOME of HOME, JOB1,
  /// JOB2): the only one without a number; empty if there is none.
  static std::string_view unexpected_start(const model::Unit& unit) {
    if (unit.initial_from != model::InitialFrom::sequence || !unit.states[unit.initial].numbered) return {};
    std::string_view rest;
    for (const model::State& state : unit.states) {
      const bool by_symbol = state.operation != model::kNone || state.event != model::kNone;
      if (state.numbered || !by_symbol) continue;
      if (!rest.empty()) return {};
      rest = state.name;
    }
    return rest;
  }

  static std::string worth_saying(const model::Unit& unit, const model::UnitEvidence& evidence) {
    if (evidence.two_words) return "whether the two words mean one state; if so, spell them alike in the list";
    std::string hint;
    const auto add = [&](std::string_view more) { hint.append(hint.empty() ? "" : "; ").append(more); };
    if (unit.initial_from == model::InitialFrom::row_order) {
      add("`initial`, which only the order of rows decided");
    }
    if (const std::string_view rest = unexpected_start(unit); !rest.empty()) {
      add(
          fmt::format("`initial`: it starts in {}, since numbered states come first; if it rests in {}, write "
                      "`\"initial\": {}`",
                      unit.states[unit.initial].name, rest, json_text(rest)));
    }
    if (evidence.initial_candidates > 1) add("`initial`, since several events start TRUE");
    if (unit.operations.empty()) {
      add("what drives it");
    } else if (unit.actuation == tables::Actuation::latched && unit.operations.size() == 2 && unit.states.size() == 2) {
      add("`actuation`, if it is a double solenoid (bistable) or a motor (held), and its travel times");
    } else {
      add("its travel times");
    }
    return hint;
  }

  /// Sample transitions, as derived and inferred. With more than two states, `*` is the source of a commanded one.
  static Json transitions_of(const model::Unit& unit) {
    Json list = Json::array();
    const auto add = [&](std::string_view from, std::string_view to, const Json& more) {
      if (list.size() >= kMostSamples) return;
      Json transition{{"from", from}, {"to", to}};
      transition.update(more);
      list.push_back(std::move(transition));
    };
    const std::string travel = seconds(unit.travel);
    for (std::uint32_t to = 0; to < unit.states.size(); ++to) {
      const std::string& name = unit.states[to].name;
      const bool own_transition = unit.actuation == tables::Actuation::spring && to == unit.rest;
      if (unit.states[to].operation == model::kNone && !own_transition) continue;
      const std::string_view from = unit.states.size() == 2 ? std::string_view(unit.states[1 - to].name) : "*";
      add(from, name, {{"takes", travel}});
    }
    for (const model::Transition& route : unit.transitions) {
      if (route.origin != model::Origin::inferred) continue;
      add(unit.states[route.from].name, unit.states[route.to].name,
          {{"automatic", true}, {"after", seconds(route.after.a)}});
    }
    if (list.empty()) {
      add(unit.states[0].name, unit.states[1].name, {{"automatic", true}, {"after", "5s"}});
    }
    return list;
  }

  const model::PlantModel& plant_;
  const model::Evidence& evidence_;
  const SkeletonList& list_;
  std::vector<Shape> shapes_;
  Json proposed_;  ///< a material flow, or null
  std::string text_;
};

}  // namespace

std::string skeleton(const model::PlantModel& plant, const model::Evidence& evidence, const SkeletonList& list) {
  return Skeleton(plant, evidence, list).write();
}

}  // namespace symplant::emit

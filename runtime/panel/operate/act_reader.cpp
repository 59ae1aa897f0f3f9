// Reads what a client of the panel asks for.
#include "symplant/panel/operate/act_reader.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "symplant/json/document.hpp"
#include "symplant/json/schema.hpp"
#include "symplant/scenario/act.hpp"
#include "symplant/scenario/read_scenario.hpp"
#include "symplant/scenario/step_reader.hpp"

namespace symplant::panel {
namespace {

using Json = nlohmann::json;
using Kind = Act::Kind;

constexpr std::size_t kMostActs = 100;
constexpr std::size_t kLongestName = 64;
constexpr double kLeastSpeed = 0.1;
constexpr double kMostSpeed = 100;

/// An act with one key whose value is `true` or a word.
struct Command {
  std::string_view key;
  std::string_view word;  ///< empty: true
  Kind kind;
};
constexpr Command kCommands[] = {
    {"run", "", Kind::run},
    {"freeze", "", Kind::freeze},
    {"reset", "", Kind::reset},
    {"step", "cycle", Kind::step_cycle},
    {"step", "change", Kind::step_change},
    {"end", "exercise", Kind::end_exercise},
};
/// An act with one key whose value is a name.
struct NamedCommand {
  std::string_view key;
  Kind kind;
};
constexpr NamedCommand kNamed[] = {
    {"snapshot", Kind::snapshot}, {"save", Kind::save},         {"restore", Kind::restore},
    {"forget", Kind::forget},     {"exercise", Kind::exercise}, {"session", Kind::session},
};
/// Keys of steps that are not acts.
constexpr std::string_view kNotActs[] = {"at",      "plus",  "wait",    "within", "expect",
                                         "include", "steps", "instant", "text",   "repeat"};

ReadActs form_error(std::string error) { return {{}, std::move(error), true}; }

}  // namespace

bool is_file_name(std::string_view name) {
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' || c == '_' ||
           c == '-' || c == '.';
  };
  return !name.empty() && name.size() <= kLongestName && name.front() != '.' && name.front() != ' ' &&
         std::all_of(name.begin(), name.end(), is_allowed);
}

struct ActReader::Parts {
  Parts(const trace::PlantNames& plant_names, const std::vector<bool>& carried, const trace::History& of)
      : names(plant_names), history(of), steps(plant_names, carried), schema(scenario::scenario_schema()) {}

  /// The act of a command; nothing if it is not a command.
  std::optional<Act> command(const Json& json, std::string& error) const {
    if (json.size() != 1) return std::nullopt;
    const std::string& key = json.begin().key();
    const Json& value = json.begin().value();
    Act act;
    bool is_key = false;
    for (const Command& each : kCommands) {
      if (key != each.key) continue;
      is_key = true;
      act.kind = each.kind;
      if (each.word.empty() ? value == true : value == each.word) return act;
    }
    if (is_key) {
      error = "`" + key + "` has the value " + value.dump() + ", which is not one of its values";
      return act;
    }
    if (key == "speed") return speed(value, error);
    for (const NamedCommand& each : kNamed) {
      if (key != each.key) continue;
      act.kind = each.kind;
      if (value.is_string()) act.name = value.get<std::string>();
      if (!is_file_name(act.name) && each.kind != Kind::exercise) {
        error = "the name of `" + key +
                "` is 1 to 64 letters, digits, blanks, `_`, `-` or `.`, and does not begin with a `.` or a blank";
      }
      return act;
    }
    return std::nullopt;
  }

  static Act speed(const Json& value, std::string& error) {
    Act act;
    act.kind = Kind::speed;
    act.speed = value.is_number() ? value.get<double>() : 0;
    if (value != "max" && !(act.speed >= kLeastSpeed && act.speed <= kMostSpeed)) {
      error = "`speed` is a number from 0.1 to 100, or \"max\"";
    }
    return act;
  }

  Act step(Json json, std::string& error) {
    Act act;
    for (const std::string_view key : kNotActs) {
      if (json.contains(key)) error = "`" + std::string(key) + "` is not an act: acts have no time and no expectation";
    }
    if (json.empty()) error = "an act without keys";
    if (!error.empty()) return act;
    const bool all = json.contains("release") && json["release"] == "all";
    if (all) json["release"] = Json::array();
    json["plus"] = "0s";
    const Json document = {{"symplant-scenario", 1}, {"steps", Json::array({json})}};
    if (const auto faults = schema.check(document); !faults.empty()) {
      error = faults.front().message;
      return act;
    }
    steps.faults.clear();
    act.step = steps.read(json, "");
    if (!steps.faults.empty()) error = steps.faults.front().message;
    if (all) {
      for (const auto& [symbol, since] : history.forced()) act.step.release.push_back(symbol);
    }
    return act;
  }

  const trace::PlantNames& names;
  const trace::History& history;
  scenario::StepReader steps;
  json::Schema schema;
};

ActReader::ActReader(const trace::PlantNames& names, const std::vector<bool>& carried, const trace::History& history)
    : parts_(std::make_unique<Parts>(names, carried, history)) {}

ActReader::~ActReader() = default;

ReadActs ActReader::read(std::string_view body) {
  const json::Document document = json::parse(body);
  if (document.root == nullptr || !document.faults.empty()) {
    return form_error(document.faults.empty() ? "the body is not JSON" : document.faults.front().message);
  }
  const Json& root = *document.root;
  const bool has_until = root.is_object() && root.contains("until");
  if (!root.is_object() || root.size() != (has_until ? 2 : 1) || !root.contains("acts") || !root["acts"].is_array()) {
    return form_error("the body is an object with the key `acts`, an array, and maybe `until`");
  }
  if (has_until && !root["until"].is_number_integer()) return form_error("`until` is an integer");
  if (root["acts"].empty() || root["acts"].size() > kMostActs) return form_error("`acts` has 1 to 100 acts");
  ReadActs read;
  if (has_until) read.until = root["until"].get<std::int64_t>();
  std::size_t changes = 0;
  for (const Json& json : root["acts"]) {
    if (!json.is_object()) return form_error("an act is an object");
    std::optional<Act> act = parts_->command(json, read.error);
    if (!act) act = parts_->step(json, read.error);
    if (!read.error.empty()) return {{}, std::move(read.error), false};
    changes += scenario::changes_by_hand(act->step);
    read.acts.push_back(std::move(*act));
  }
  if (changes > engine::kMostByHand) {
    return form_error("the acts change " + std::to_string(changes) + " parts and malfunctions; at most " +
                      std::to_string(engine::kMostByHand) + " at once");
  }
  return read;
}

}  // namespace symplant::panel

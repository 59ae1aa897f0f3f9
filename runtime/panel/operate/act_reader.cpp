// Reads what a client of the panel asks for.
#include "symplant/panel/operate/act_reader.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "symplant/json/document.hpp"
#include "symplant/json/schema.hpp"
#include "symplant/panel/training/messages.hpp"
#include "symplant/scenario/act.hpp"
#include "symplant/scenario/read_scenario.hpp"
#include "symplant/scenario/step_reader.hpp"
#include "symplant/tables/duration.hpp"
#include "symplant/tables/file_name.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::panel {
namespace {

using Json = nlohmann::json;
using Kind = Act::Kind;

constexpr std::size_t kMostActs = 100;
constexpr double kLeastSpeed = 0.1;
constexpr double kMostSpeed = 100;
constexpr tables::Time kLongestShelving = 24 * 3600 * tables::kSecond;

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
    {"join", "", Kind::join},
    {"count", "utilization", Kind::count_again},
    {"silence", "", Kind::silence},
};
/// An act with one key whose value is a name.
struct NamedCommand {
  std::string_view key;
  Kind kind;
};
constexpr NamedCommand kNamed[] = {
    {"snapshot", Kind::snapshot}, {"save", Kind::save},       {"restore", Kind::restore}, {"forget", Kind::forget},
    {"exercise", Kind::exercise}, {"session", Kind::session}, {"message", Kind::message}, {"camera", Kind::camera},
};
/// An act whose value is the name of an alarm, or a list of names.
constexpr NamedCommand kOfAlarms[] = {
    {"acknowledge", Kind::acknowledge}, {"shelve", Kind::shelve}, {"unshelve", Kind::unshelve}};
constexpr std::string_view kShelve = "shelve";
constexpr std::string_view kFor = "for";  ///< the second key of `shelve`
constexpr std::string_view kSpeed = "speed";
/// Keys of steps that are acts; one act may have several of them.
constexpr std::string_view kOfStep[] = {"restart", "set", "state", "put", "take", "force", "release", "start", "stop"};
/// Those of them that only a trainer may do.
constexpr std::string_view kOfTrainer[] = {"restart", "force", "release", "start", "stop"};
/// Keys of steps that are not acts.
constexpr std::string_view kNotActs[] = {"at",      "plus",  "wait",    "within", "expect",
                                         "include", "steps", "instant", "text",   "repeat"};

ReadActs form_error(std::string error) { return {{}, std::move(error), true}; }

template <class Keys>
bool is_one_of(const Keys& keys, std::string_view key) {
  return std::find(std::begin(keys), std::end(keys), key) != std::end(keys);
}

/// The keys of commands, which are alone in their act.
const std::vector<std::string_view>& command_keys() {
  static const std::vector<std::string_view> keys = [] {
    std::vector<std::string_view> all{kSpeed};
    for (const Command& each : kCommands) all.push_back(each.key);
    for (const NamedCommand& each : kNamed) all.push_back(each.key);
    for (const NamedCommand& each : kOfAlarms) all.push_back(each.key);
    return all;
  }();
  return keys;
}

/// "`forse` is not `of`; did you mean `force`?"
template <class... Lists>
std::string unknown_key(const std::string& key, std::string_view of, const Lists&... known) {
  tables::NearestName nearest(key);
  (std::for_each(std::begin(known), std::end(known), [&](std::string_view name) { nearest.offer(name); }), ...);
  std::string error = "`" + key + "` is not " + std::string(of);
  if (!nearest.name().empty()) error += "; did you mean `" + std::string(nearest.name()) + "`?";
  return error;
}

/// What is wrong with the keys of an act; empty if nothing is.
std::string key_error(const Json& act) {
  if (act.size() == 2 && act.contains(kShelve) && act.contains(kFor)) return "";
  if (act.contains(kFor)) {
    return act.contains(kShelve) ? "`shelve` and `for` are alone in an act; put the other keys into separate acts"
                                 : "`for` is a key of `shelve` only";
  }
  for (const auto& [key, value] : act.items()) {
    const bool is_command = is_one_of(command_keys(), key);
    if (is_command && act.size() > 1) return "`" + key + "` is alone in an act; put the other keys into separate acts";
    if (!is_command && !is_one_of(kOfStep, key) && !is_one_of(kNotActs, key)) {
      return unknown_key(key, "the key of an act", kOfStep, command_keys());
    }
  }
  return "";
}

template <class Keys>
bool has_key_of(const Json& act, const Keys& keys) {
  return std::any_of(act.items().begin(), act.items().end(),
                     [&](const auto& item) { return is_one_of(keys, item.key()); });
}

/// The first key of an act that has no effect, since its value is an empty array or object; empty if each key has one.
std::string idle_key(const Json& act) {
  for (const auto& [key, value] : act.items()) {
    if ((value.is_array() || value.is_object()) && value.empty()) return key;
  }
  return "";
}

}  // namespace

struct ActReader::Parts {
  Parts(const trace::PlantNames& plant_names, const std::vector<bool>& carried, const trace::History& of)
      : names(plant_names), history(of), steps(plant_names, carried), schema(scenario::scenario_schema()) {}

  /// An act on alarms; nothing if it is another act.
  static std::optional<Act> of_alarms(const Json& json, std::string& error) {
    for (const NamedCommand& each : kOfAlarms) {
      const auto value = json.find(each.key);
      if (value == json.end()) continue;
      Act act;
      act.kind = each.kind;
      if (each.kind == Kind::acknowledge && *value == "all") return act;
      if (value->is_string()) act.alarms = {value->get<std::string>()};
      if (value->is_array() &&
          std::all_of(value->begin(), value->end(), [](const Json& name) { return name.is_string(); })) {
        act.alarms = value->get<std::vector<std::string>>();
      }
      if (act.alarms.empty()) {
        error = "`" + std::string(each.key) + "` has the name of an alarm, or a list of names" +
                (each.kind == Kind::acknowledge ? ", or \"all\"" : "");
      }
      if (each.kind == Kind::shelve && error.empty()) act.shelved_for = shelving(json, error);
      return act;
    }
    return std::nullopt;
  }

  static tables::Time shelving(const Json& json, std::string& error) {
    const auto given = json.find(kFor);
    const auto time = given != json.end() && given->is_string()
                          ? tables::parse_duration(given->get_ref<const std::string&>())
                          : std::nullopt;
    if (!time || *time <= 0 || *time > kLongestShelving) {
      error = "`shelve` needs the key `for`: a duration of plant time up to 24 h, such as \"10min\"";
    }
    return time.value_or(0);
  }

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
    if (key == kSpeed) return speed(value, error);
    for (const NamedCommand& each : kNamed) {
      if (key != each.key) continue;
      act.kind = each.kind;
      if (value.is_string()) act.name = value.get<std::string>();
      if (each.kind == Kind::message) {
        if (!is_message(act.name)) error = kMessageForm;
        return act;
      }
      if (each.kind == Kind::camera) {
        if (!value.is_string()) error = "`camera` is the name of a camera, or \"\" for the overview";
        return act;
      }
      if (!tables::is_file_name(act.name) && each.kind != Kind::exercise) {
        error = "the name of `" + key + "` is " + tables::kFileNameForm;
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
    if (const std::string key = idle_key(json); error.empty() && !key.empty()) {
      error = "`" + key + "` is empty and has no effect; name at least one item";
    }
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
    act.releases_all = all;
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

ReadActs ActReader::read(std::string_view body, Role role) {
  const json::Document document = json::parse(body);
  if (document.root == nullptr || !document.faults.empty()) {
    return form_error(document.faults.empty() ? "the body is not JSON" : document.faults.front().message);
  }
  const Json& root = *document.root;
  constexpr std::string_view kBody[] = {"acts", "until"};
  if (root.is_object()) {
    for (const auto& [key, value] : root.items()) {
      if (!is_one_of(kBody, key)) return form_error(unknown_key(key, "a key of the body", kBody));
    }
  }
  const bool has_until = root.is_object() && root.contains("until");
  if (!root.is_object() || !root.contains("acts") || !root["acts"].is_array()) {
    return form_error("the body is an object with the key `acts`, an array, and maybe `until`");
  }
  if (has_until && !root["until"].is_number_integer()) return form_error("`until` is an integer");
  if (root["acts"].empty() || root["acts"].size() > kMostActs) return form_error("`acts` has 1 to 100 acts");
  ReadActs read;
  if (has_until) read.until = root["until"].get<std::int64_t>();
  std::size_t changes = 0;
  for (const Json& json : root["acts"]) {
    if (!json.is_object()) return form_error("an act is an object");
    if (std::string error = key_error(json); !error.empty()) return form_error(std::move(error));
    if (!sees_all(role) && has_key_of(json, kOfTrainer)) return {{}, kOnlyTrainer, false, true};
    std::optional<Act> act = Parts::of_alarms(json, read.error);
    if (!act) act = parts_->command(json, read.error);
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

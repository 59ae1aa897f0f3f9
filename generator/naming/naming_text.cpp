// Writes a naming rule as JSON.
#include "naming/naming_text.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace symplant::naming {
namespace {

using Json = nlohmann::ordered_json;

std::string_view said_text(name::Said says) {
  if (!says) return "internal";
  return *says == name::Direction::operation ? "operation" : "event";
}

std::string_view role_text(name::Role role) {
  constexpr std::array<std::string_view, 6> kRoles = {"", "operator", "data", "interlock", "constant", "none"};
  return kRoles[static_cast<std::size_t>(role)];
}

std::string_view source_text(name::Source source) {
  constexpr std::array<std::string_view, 4> kSources = {"", "name", "comment", "parent+comment"};
  return kSources[static_cast<std::size_t>(source)];
}

std::string_view model_text(name::ArchetypeModel model) {
  constexpr std::array<std::string_view, name::kArchetypeModels> kModels = {"mirror", "handshake", "constant",
                                                                            "two-position", "contactor"};
  return kModels[static_cast<std::size_t>(model)];
}

std::string_view evidence_text(name::Evidence evidence) {
  constexpr std::array<std::string_view, 4> kEvidence = {"address", "field", "class", "prefix"};
  return kEvidence[static_cast<std::size_t>(evidence)];
}

std::string duration_text(std::int64_t time) {
  constexpr std::array<std::pair<std::int64_t, std::string_view>, 3> kUnits = {
      {{1'000'000'000, "s"}, {1'000'000, "ms"}, {1'000, "us"}}};
  for (const auto& [size, unit] : kUnits) {
    if (time % size == 0) return std::to_string(time / size) + std::string(unit);
  }
  return std::to_string(time) + "ns";
}

Json words_json(const std::vector<name::DirectionWord>& words) {
  Json json = Json::object();
  for (const name::DirectionWord& word : words) json[word.word] = said_text(word.says);
  return json;
}

Json replace_json(const std::vector<name::Replacement>& replacements) {
  Json json = Json::array();
  for (const name::Replacement& one : replacements) json.push_back(Json::array({one.expression, one.replacement}));
  return json;
}

Json normalise_json(const name::Normalise& normalise) {
  const name::Normalise usual;
  Json json = Json::object();
  if (normalise.collapse != usual.collapse) json["collapse"] = normalise.collapse;
  if (!normalise.line_break.empty()) json["line-break"] = normalise.line_break;
  if (normalise.columns != 0) json["columns"] = normalise.columns;
  if (normalise.camel_case) json["camel-case"] = true;
  if (!normalise.replace.empty()) json["replace"] = replace_json(normalise.replace);
  return json;
}

Json rule_json(const name::SymbolRule& rule) {
  Json json = Json::object();
  if (!rule.name.empty()) json["name"] = rule.name;
  if (rule.patterns.size() == 1) {
    const name::SourcePattern& one = rule.patterns.front();
    if (one.source != name::Source::name_then_comment) json["source"] = source_text(one.source);
    json["pattern"] = one.pattern;
  } else {
    for (const name::SourcePattern& one : rule.patterns) json["pattern"][source_text(one.source)] = one.pattern;
  }
  for (const name::FieldRule& field : rule.fields) {
    json["fields"][field.field] = field.words.empty() ? Json(field.expression) : words_json(field.words);
  }
  if (!rule.classes.empty()) json["classes"] = words_json(rule.classes);
  if (!rule.replace.empty()) json["replace"] = replace_json(rule.replace);
  if (!rule.has.empty()) json["has"] = rule.has;
  if (rule.side) json["side"] = said_text(rule.side);
  if (rule.task) json["task"] = *rule.task;
  if (rule.exact) json["exact"] = true;
  if (rule.unlinked_states) json["unlinked"] = "states";
  if (rule.fan_out) json["fan-out"] = true;
  if (rule.role != name::Role::io) json["role"] = role_text(rule.role);
  if (rule.value) json["value"] = *rule.value;
  return json;
}

Json tasks_json(const name::TaskRules& tasks) {
  const name::TaskRules usual;
  Json json = Json::object();
  if (!tasks.vocabulary) json["vocabulary"] = false;
  for (const auto& [rest, other] : tasks.pairs) json["pairs"].push_back(Json::array({rest, other}));
  if (!tasks.operation_affixes.empty()) json["affixes"]["operation"] = tasks.operation_affixes;
  if (!tasks.event_affixes.empty()) json["affixes"]["event"] = tasks.event_affixes;
  for (const auto& [words, canonical] : tasks.synonyms) json["synonyms"][words] = canonical;
  if (tasks.sensor_index != usual.sensor_index) {
    json["sensor-index"] = tasks.sensor_index == name::SensorIndex::appended
                               ? Json("appended")
                               : Json(tasks.sensor_index != name::SensorIndex::off);
  }
  if (tasks.sequence) json["sequence"] = true;
  return json;
}

Json archetype_json(const name::Archetype& archetype) {
  const name::Archetype usual;
  Json json = {{"name", archetype.name}, {"model", model_text(archetype.model)}};
  for (const auto& [role, text] : archetype.texts) json[std::string(name::archetype_role_name(role))] = text;
  if (archetype.delay != usual.delay) json["delay"] = duration_text(archetype.delay);
  if (archetype.takes != usual.takes) json["takes"] = duration_text(archetype.takes);
  if (archetype.inverted) json["inverted"] = true;
  if (archetype.model == name::ArchetypeModel::constant) json["value"] = archetype.value;
  return json;
}

Json direction_json(const name::DirectionRule& direction) {
  Json json = Json::object();
  if (direction.evidence != name::DirectionRule().evidence) {
    for (const name::Evidence evidence : direction.evidence) json["evidence"].push_back(evidence_text(evidence));
  }
  if (direction.conflict_is_error) json["on-conflict"] = "error";
  return json;
}

/// An object with a line for each of its members, and a line for each element of long arrays.
class Lines {
 public:
  void add(std::string_view key, const Json& value) {
    if (value.is_object() && value.empty()) return;
    text_ += text_.empty() ? "{ " : ",\n  ";
    text_ += Json(key).dump() + ": " + one_line(value);
  }

  void add_list(std::string_view key, const std::vector<Json>& values) {
    if (values.empty()) return;
    text_ += ",\n  " + Json(key).dump() + ": [";
    for (std::size_t i = 0; i < values.size(); ++i) text_ += (i == 0 ? "\n    " : ",\n    ") + one_line(values[i]);
    text_ += "]";
  }

  std::string take() { return text_ + " }\n"; }

 private:
  /// Compact, with a blank after each colon and comma, and inside of braces.
  static std::string one_line(const Json& value) {
    if (value.is_object()) {
      std::string text;
      for (const auto& [key, member] : value.items()) {
        text += (text.empty() ? "{ " : ", ") + Json(key).dump() + ": " + one_line(member);
      }
      return text.empty() ? "{}" : text + " }";
    }
    if (value.is_array()) {
      std::string text;
      for (const Json& element : value) text += (text.empty() ? "[" : ", ") + one_line(element);
      return text.empty() ? "[]" : text + "]";
    }
    return value.dump();
  }

  std::string text_;
};

template <class Values, class ToJson>
std::vector<Json> jsons(const Values& values, ToJson to_json) {
  std::vector<Json> all;
  all.reserve(values.size());
  for (const auto& value : values) all.push_back(to_json(value));
  return all;
}

}  // namespace

std::string naming_text(const name::Naming& naming, std::string_view links_file) {
  constexpr std::array<std::string_view, 3> kLevels = {"line", "process", "device"};
  Lines lines;
  lines.add("symplant-naming", 1);
  if (!naming.name.empty()) lines.add("name", naming.name);
  lines.add("normalise", normalise_json(naming.normalise));
  lines.add("separators", naming.separators);
  if (!naming.ignore.empty()) lines.add("ignore", naming.ignore);
  lines.add_list("rules", jsons(naming.rules, rule_json));
  lines.add_list("rest", jsons(naming.rest, rule_json));
  Json fixed = Json::object();
  for (const auto& [level, text] : naming.fixed) fixed[kLevels[static_cast<std::size_t>(level)]] = text;
  lines.add("fixed", fixed);
  lines.add("direction", direction_json(naming.direction));
  if (naming.units == name::Units::device) lines.add("units", "device");
  lines.add("tasks", tasks_json(naming.tasks));
  if (!links_file.empty()) lines.add("links", links_file);
  if (links_file.empty()) {
    lines.add_list("links", jsons(naming.links, [](const name::NamedLink& link) {
                     return Json::array({link.operation, link.event, link.state});
                   }));
  }
  lines.add_list("archetypes", jsons(naming.archetypes, archetype_json));
  return lines.take();
}

}  // namespace symplant::naming

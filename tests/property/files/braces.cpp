// Names of a matched device in braces.
#include "property/files/braces.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "support/reference/patterns.hpp"
#include "support/reference/rules.hpp"

namespace symplant::property::files {
namespace {

using nlohmann::json;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_name_part(char c) { return is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Names, words and numbers of a condition; a quoted name with its quotes.
std::vector<std::string> tokens_of(const std::string& condition) {
  std::vector<std::string> tokens(1);
  bool quoted = false;
  for (const char c : condition) {
    if (c == '\'') quoted = !quoted;
    if (!quoted && (c == ' ' || c == '(' || c == ')')) {
      tokens.emplace_back();
    } else {
      tokens.back() += c;
    }
  }
  std::erase(tokens, std::string());
  return tokens;
}

bool is_word(const std::string& token) { return token == "and" || token == "or" || token == "not"; }

bool is_name(const std::string& token) {
  return !is_word(token) && (is_letter(token[0]) || token[0] == '\'' || token[0] == '{');
}

/// Whether an expanded name can be read as one.
bool reads_as_name(const std::string& token) {
  if (token.empty() || is_word(token)) return false;
  if (token[0] == '\'') return token.size() > 2;
  return is_letter(token[0]) && token.back() != '.' && std::all_of(token.begin(), token.end(), [](char c) {
           return is_name_part(c) || c == '.' || c == '*' || c == '?';
         });
}

/// Positions at which `part` is outside braces and within a name.
std::vector<std::size_t> occurrences(const std::string& text, const std::string& part) {
  std::vector<std::size_t> found;
  std::size_t begin = 0;
  bool braces = false;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\'') quoted = !quoted;
    braces = text[i] == '{' || (braces && text[i] != '}');
    if (!quoted && (text[i] == ' ' || text[i] == '(' || text[i] == ')')) begin = i + 1;
    if (braces || text[i] == '}' || text.compare(i, part.size(), part) != 0) continue;
    const std::size_t end = std::min(text.find_first_of(" ()", begin), text.size());
    if (begin < end && is_name(text.substr(begin, end - begin)) && i + part.size() <= end) found.push_back(i);
  }
  return found;
}

/// Puts `{name}` for one or all of its replacement's occurrences.
void put(Dice& dice, std::string& text, const std::string& name, const std::string& replacement, bool all) {
  for (int puts = 0; puts < 20; ++puts) {
    const std::vector<std::size_t> found = occurrences(text, replacement);
    if (found.empty() || (replacement.empty() && puts > 0)) return;
    text.replace(all ? found.front() : dice.pick(found), replacement.size(), "{" + name + "}");
    if (!all) return;
  }
}

/// The names in a condition, in upper case, without quotes.
std::vector<std::string> names_in(const std::string& condition) {
  std::vector<std::string> names;
  for (std::string token : tokens_of(condition)) {
    if (!is_name(token)) continue;
    std::erase(token, '\'');
    names.push_back(reference::upper(token));
  }
  return names;
}

}  // namespace

BraceNames brace_names(const std::string& path, const std::string& pattern) {
  const std::size_t first = path.find('_');
  const std::size_t second = path.find('_', first + 1);
  BraceNames names{{"line", path.substr(0, first)},
                   {"process", path.substr(first + 1, second - first - 1)},
                   {"device", path.substr(second + 1)},
                   {"self", path}};
  int number = 0;
  for (const std::string& share : reference::shares(path, pattern)) names[std::to_string(++number)] = share;
  return names;
}

bool has_braces(const std::string& text) { return text.find('{') != text.npos; }

std::string expanded(const std::string& text, const BraceNames& names) {
  std::string result = text;
  for (const auto& [name, replacement] : names) {
    const std::string braces = "{" + name + "}";
    for (std::size_t at = 0; (at = result.find(braces, at)) != result.npos; at += replacement.size()) {
      result.replace(at, braces.size(), replacement);
    }
  }
  return result;
}

bool stays_a_condition(const std::string& condition, const BraceNames& names) {
  for (const std::string& token : tokens_of(condition)) {
    if (has_braces(token) && !reads_as_name(expanded(token, names))) return false;
  }
  return true;
}

std::string with_braces(Dice& dice, const std::string& text, const BraceNames& names) {
  static const std::vector<std::string> kLevels = {"line", "process", "device"};
  std::string result = text;
  if (dice.percent(60)) put(dice, result, "self", names.at("self"), true);
  if (has_braces(result) && dice.percent(30)) {
    result = text;
    put(dice, result, "self", names.at("self"), true);
    for (std::size_t at = 0; (at = result.find("{self}", at)) != result.npos;) {
      result.replace(at, 6, "{line}_{process}_{device}");
    }
  }
  if (dice.percent(80)) put(dice, result, "line", names.at("line"), true);
  std::vector<std::string> all;
  for (const auto& [name, replacement] : names) all.push_back(name);
  for (std::size_t i = dice.below(4); i > 0; --i) {
    const std::string& name = dice.percent(70) ? dice.pick(all) : dice.pick(kLevels);
    put(dice, result, name, names.at(name), dice.percent(50));
  }
  return stays_a_condition(result, names) ? result : text;
}

void edit_texts(json& value, const std::string& key, const std::function<std::string(const std::string& text)>& edit) {
  std::map<std::string, std::string> edited;
  const auto change = [&](json& text) {
    const auto before = text.get<std::string>();
    const auto found = edited.find(before);
    text = found != edited.end() ? found->second : edited.try_emplace(before, edit(before)).first->second;
  };
  if (key == "transitions") {
    for (json& transition : value) {
      for (const char* member : {"when", "while"}) {
        if (transition.contains(member)) change(transition[member]);
      }
    }
  } else if (key == "inputs") {
    for (json& condition : value) change(condition);
  } else if (key == "disables") {
    for (json& devices : value) {
      for (json& device : devices) change(device);
    }
  }
}

KnownNames known_names(const model::PlantModel& plant) {
  KnownNames known;
  for (const reference::UnitRules& unit : reference::derive(plant, {}).units) {
    const std::string path = reference::upper(unit.path);
    known.devices.insert(path);
    known.in_conditions.insert(path + ".MOVING");
    for (const reference::StateRules& state : unit.states) {
      known.in_conditions.insert(path + "." + reference::upper(state.name));
    }
  }
  const model::Material& material = plant.material;
  for (std::uint32_t i = 0; i < material.locations(); ++i) {
    const std::string location = reference::upper(material.location_name(i)) + ".";
    known.in_conditions.insert(location + "PART");
    known.in_conditions.insert(location + "PARTS");
    for (const model::PartKind& kind : material.kinds) {
      known.in_conditions.insert(location + reference::upper(kind.name));
    }
  }
  for (const model::Symbol& symbol : plant.symbols) known.in_conditions.insert(reference::upper(symbol.name()));
  return known;
}

bool knows_device(const KnownNames& known, const std::string& path) {
  return known.devices.contains(reference::upper(path));
}

bool knows(const KnownNames& known, const std::string& condition) {
  const auto names = names_in(condition);
  return std::all_of(names.begin(), names.end(),
                     [&](const std::string& name) { return known.in_conditions.contains(name); });
}

}  // namespace symplant::property::files

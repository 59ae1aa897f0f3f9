// The second resolver of patterns.
#include "property/files/resolve_entries.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

namespace symplant::property::files {
namespace {

using nlohmann::json;

bool lacks(const Wish& device, std::string task) {
  for (char& c : task) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return task != "*" && !device.tasks.contains(task);
}

bool lacks(const Wish& device, const json& transition) {
  for (const char* key : {"from", "to", "on"}) {
    if (transition.contains(key) && lacks(device, transition[key].get<std::string>())) return true;
  }
  return false;
}

/// Makes the names in a text with braces; false if the plant lacks one.
bool make(json& text, const BraceNames& names, const std::function<bool(const std::string&)>& known) {
  const auto before = text.get<std::string>();
  if (!has_braces(before)) return true;
  const std::string after = expanded(before, names);
  text = after;
  return known(after);
}

class LeavingOut {
 public:
  LeavingOut(const Wish& device, const std::string& pattern)
      : device_(device), names_(brace_names(device.path, pattern)) {}

  json transitions(const json& value) {
    // Tasks named by a transition that is left out like this may still be states, or not: users should not rely on
    // that.
    const bool names_tasks = device_.keys.contains("outputs") ||
                             std::any_of(value.begin(), value.end(), [](const json& it) { return it.contains("on"); });
    json kept = json::array();
    for (json each : value) {
      bool known = true;
      for (const char* key : {"when", "while"}) {
        if (each.contains(key)) known = make(each[key], names_, known_condition()) && known;
      }
      const bool lacking = lacks(device_, each);
      if (!lacking && (known || names_tasks)) kept.push_back(each);
      count(lacking, known);
    }
    return kept;
  }

  json disables(const json& value) {
    json kept = json::object();
    for (const auto& member : value.items()) {
      if (lacks(device_, member.key())) {
        count(true, true);
        continue;
      }
      kept[member.key()] = json::array();
      for (json each : member.value()) {
        const bool known = make(each, names_, [&](const std::string& name) {
          return reference::is_pattern(name) || knows_device(*device_.known, name);
        });
        if (known) kept[member.key()].push_back(each);
        count(false, known);
      }
    }
    return kept;
  }

  json outputs(const json& value) {
    json kept = json::object();
    for (const auto& member : value.items()) {
      const bool lacking = lacks(device_, member.key());
      if (!lacking) kept[member.key()] = member.value();
      count(lacking, true);
    }
    return kept;
  }

  json inputs(const json& value) {
    json kept = json::object();
    for (const auto& member : value.items()) {
      json text = member.value();
      const bool known = make(text, names_, known_condition());
      if (known) kept[member.key()] = text;
      count(false, known);
    }
    return kept;
  }

  LeftOut left_out;

 private:
  void count(bool lacking, bool known) {
    left_out.parts += lacking || !known ? 1 : 0;
    left_out.made += !lacking && !known ? 1 : 0;
  }
  std::function<bool(const std::string&)> known_condition() const {
    return [this](const std::string& text) { return knows(*device_.known, text); };
  }

  const Wish& device_;
  const BraceNames names_;
};

}  // namespace

json made(const Entry& entry, const Wish& device, const std::string& key) {
  json value = entry.keys.at(key);
  if (entry.exact()) return value;
  const BraceNames names = brace_names(device.path, entry.name);
  edit_texts(value, key, [&](const std::string& text) { return expanded(text, names); });
  return value;
}

LeftOut leave_out(json& value, const Wish& device, const std::string& key, const std::string& pattern) {
  LeavingOut leaving(device, pattern);
  if (key == "initial" || key == "rest") {
    if (!lacks(device, value.get<std::string>())) return {};
    value = nullptr;
    return {1, 0};
  }
  if (key == "transitions") value = leaving.transitions(value);
  if (key == "outputs") value = leaving.outputs(value);
  if (key == "disables") value = leaving.disables(value);
  if (key == "inputs") value = leaving.inputs(value);
  return leaving.left_out;
}

Resolved resolve(const std::vector<Entry>& entries, const Wish& device, const std::string& key) {
  Resolved it;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto said = entries[i].keys.find(key);
    if (said == entries[i].keys.end() || !fits(device.path, entries[i].name)) continue;
    // A clash also counts if a third entry beats both: users should not rely on that.
    for (std::size_t j = 0; j < i; ++j) {
      const auto other = entries[j].keys.find(key);
      if (other == entries[j].keys.end() || entries[i].exact() || entries[j].exact()) continue;
      if (!fits(device.path, entries[j].name) || literals(entries[i].name) != literals(entries[j].name)) continue;
      // So does one text that is not the same name for both.
      it.clash =
          it.clash || other->second != said->second || made(entries[i], device, key) != made(entries[j], device, key);
      ++it.agreeing;
    }
    if (it.entry) ++it.beaten;
    const auto better = [&](const Entry& a, const Entry& b) {
      return a.exact() != b.exact() ? a.exact() : literals(a.name) > literals(b.name);
    };
    if (!it.entry || better(entries[i], entries[*it.entry])) {
      it.entry = i;
      it.best.clear();
    }
    if (!better(entries[*it.entry], entries[i])) it.best.insert(i);
  }
  if (!it.entry) return it;
  it.value = entries[*it.entry].keys.at(key);
  const Entry& entry = entries[*it.entry];
  if (!entry.exact()) it.left_out = leave_out(it.value, device, key, entry.name);
  return it;
}

json neutral(const std::string& key) {
  if (key == "states" || key == "transitions") return json::array();
  if (key == "outputs" || key == "disables" || key == "inputs") return json::object();
  if (key == "only") return false;
  return nullptr;
}

bool same_meaning(const std::string& key, const json& a, const json& b) {
  const auto says_nothing = [&](const json& value) { return value.is_null() || value == neutral(key); };
  return a == b || (says_nothing(a) && says_nothing(b));
}

}  // namespace symplant::property::files

// The second resolver of patterns.
#include "property/files/resolve_entries.hpp"

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

}  // namespace

long leave_out(json& value, const Wish& device, const std::string& key) {
  if (key == "initial" || key == "rest") {
    if (!lacks(device, value.get<std::string>())) return 0;
    value = nullptr;
    return 1;
  }
  long left_out = 0;
  if (key == "transitions") {
    json kept = json::array();
    for (const json& each : value) {
      if (!lacks(device, each)) kept.push_back(each);
    }
    left_out = std::ssize(value) - std::ssize(kept);
    value = kept;
  } else if (key == "outputs" || key == "disables") {
    json kept = json::object();
    for (const auto& member : value.items()) {
      if (!lacks(device, member.key())) kept[member.key()] = member.value();
    }
    left_out = std::ssize(value) - std::ssize(kept);
    value = kept;
  }
  return left_out;
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
      it.clash = it.clash || other->second != said->second;
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
  if (!entries[*it.entry].exact()) it.left_out = leave_out(it.value, device, key);
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

// Reads the alarms of the description.
#include "elements/alarm/entry.hpp"

#include <nlohmann/json.hpp>
#include <string>

#include "description/json_entry.hpp"

namespace symplant::description {
namespace {

using tables::AlarmPriority;

std::optional<AlarmPriority> priority_of(const nlohmann::json& entry) {
  const std::string text = text_or_empty(entry, "priority");
  if (text.empty()) return std::nullopt;
  if (text == "high") return AlarmPriority::high;
  return text == "medium" ? AlarmPriority::medium : AlarmPriority::low;
}

}  // namespace

std::vector<GivenAlarm> alarms_of(const nlohmann::json& root) {
  std::vector<GivenAlarm> alarms;
  const nlohmann::json* const given = member(root, "alarms");
  if (given == nullptr || !given->is_array()) return alarms;
  for (const nlohmann::json& one : *given) {
    std::string of = one.is_string() ? one.get<std::string>() : text_or_empty(one, "of");
    if (!of.empty()) alarms.push_back({std::move(of), priority_of(one)});
  }
  return alarms;
}

}  // namespace symplant::description

// Reads `follow` of a plant.json.
#include "elements/follow/entry.hpp"

#include <nlohmann/json.hpp>

#include "description/json_entry.hpp"

namespace symplant::description {

std::vector<GivenFollow> follow_entries(const nlohmann::json& object) {
  std::vector<GivenFollow> follow;
  if (!object.is_object()) return follow;
  for (const auto& [symbol, condition] : object.items()) {
    if (condition.is_string()) follow.push_back({symbol, condition.get<std::string>(), {}});
    if (condition.is_object()) {
      follow.push_back({symbol, text_or_empty(condition, "on"), text_or_empty(condition, "off")});
    }
  }
  return follow;
}

}  // namespace symplant::description

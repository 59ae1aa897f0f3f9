// Reads `requirements` of a plant.json.
#include "elements/requirement/entry.hpp"

#include <nlohmann/json.hpp>

namespace symplant::description {

std::vector<GivenRequirement> requirement_entries(const nlohmann::json& array, ShapeFaults& faults) {
  std::vector<GivenRequirement> requirements;
  if (!array.is_array()) return requirements;
  for (std::size_t i = 0; i < array.size(); ++i) {
    const nlohmann::json& value = array[i];
    const Pointer here = Pointer("/requirements") / i;
    const auto within = duration_member(value, "within", here, faults).value_or(Duration::fixed(0));
    const bool between = within.kind == Duration::Kind::uniform;
    check_text(text_or_empty(value, "name"), here / "name", faults);
    requirements.push_back({text_or_empty(value, "name"), text_or_empty(value, "never"), text_or_empty(value, "after"),
                            text_or_empty(value, "expect"), between ? within.b : within.a, text_or_empty(value, "for"),
                            between ? within.a : 0});
  }
  return requirements;
}

}  // namespace symplant::description

// Requirements in words, for tables and pages.
#include "elements/requirement/words.hpp"

#include <fmt/format.h>

#include "model/condition_text.hpp"
#include "view/words.hpp"

namespace symplant::view {

std::string requirement_text(const model::Requirement& requirement, const model::PlantModel& plant) {
  const std::string condition = model::condition_text(requirement.condition, plant);
  if (requirement.kind == tables::RequirementRow::Kind::never) return "never " + condition;
  const std::string expected = model::condition_text(requirement.expected, plant);
  if (requirement.earliest == 0) {
    return fmt::format("after {}, expect {} within {}", condition, expected, time_text(requirement.within));
  }
  return fmt::format("after {}, expect {} within {} to {}", condition, expected, time_text(requirement.earliest),
                     time_text(requirement.within));
}

}  // namespace symplant::view

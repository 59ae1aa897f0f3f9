// The requirements as JSON, for programs.
#include "elements/requirement/json.hpp"

#include "model/condition_text.hpp"

namespace symplant::view {

void write_requirements(const model::PlantModel& plant, JsonWriter& json) {
  json.key("requirements");
  json.array(plant.requirements, [&](const model::Requirement& requirement) {
    const std::string condition = model::condition_text(requirement.condition, plant);
    json.begin_object();
    json.member("name", requirement.name);
    if (requirement.kind == tables::RequirementRow::Kind::never) {
      json.member("never", condition);
    } else {
      json.member("after", condition);
      json.member("expect", model::condition_text(requirement.expected, plant));
      if (requirement.earliest != 0) json.member("earliest", requirement.earliest);
      json.member("within", requirement.within);
    }
    json.end_object();
  });
}

}  // namespace symplant::view

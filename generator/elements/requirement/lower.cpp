// Lowers the requirements.
#include "elements/requirement/lower.hpp"

namespace symplant::lower {

void lower_requirements(const model::PlantModel& plant, const AddCondition& add_condition, EngineTables& tables) {
  for (std::uint32_t r = 0; r < plant.requirements.size(); ++r) {
    const model::Requirement& requirement = plant.requirements[r];
    tables::RequirementRow row{requirement.kind, 0, 0, requirement.within, requirement.earliest};
    row.condition = add_condition(requirement.condition, tables::ReaderKind::requirement, r, 0);
    if (requirement.kind == tables::RequirementRow::Kind::expect) {
      row.expected = add_condition(requirement.expected, tables::ReaderKind::requirement, r, 1);
    }
    tables.requirements.push_back(row);
    tables.requirement_names.append(requirement.name).push_back('\0');
  }
}

}  // namespace symplant::lower

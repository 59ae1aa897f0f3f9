// Checks and resolves the links in a description.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/faults.hpp"
#include "symplant/link/link_settings.hpp"

namespace symplant::model {

struct PlantModel;

/// Reports an unknown controller, a missing one if the plant has several, and two links of one controller. Returns for
/// each controller the link whose settings apply, or null. O(links * controllers).
std::vector<const description::LinkDescription*> check_links(const PlantModel& plant, description::Faults& faults);

/// Reports an unknown controller of a program, a missing one if the plant has several, and two programs of one
/// controller. O(programs * controllers).
void check_programs(const PlantModel& plant, description::Faults& faults);

/// Makes PlantModel::links, the settings by controller. Shared addresses must be known. Reports unknown names in the
/// entries of a `map`, and entries that contradict each other. O(symbols * entries).
void resolve_links(PlantModel& plant, const std::vector<const description::LinkDescription*>& links,
                   description::Faults& faults);

}  // namespace symplant::model

// What a description says of links to PLCs.
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

/// Records what is wrong with the links of a plant's description: a controller that the plant has not, none named where
/// that leaves it open, two links of one controller. Gives by controller the link whose settings hold; null: none.
/// O(links * controllers).
std::vector<const description::LinkDescription*> check_links(const PlantModel& plant, description::Faults& faults);

/// Makes PlantModel::links, the settings by controller; shared addresses must be known. Records what an entry of a
/// `map` names and is not there, and where two say different things of one symbol. O(symbols * entries).
void resolve_links(PlantModel& plant, const std::vector<const description::LinkDescription*>& links,
                   description::Faults& faults);

}  // namespace symplant::model

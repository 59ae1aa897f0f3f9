// The schema of plant.json.
#pragma once

#include <string_view>

namespace symplant::description {

/// The schema of plant.json, as `symplant schema plant` prints it.
std::string_view plant_schema();

}  // namespace symplant::description

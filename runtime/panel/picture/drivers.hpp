// What drives each event.
#pragma once

#include <string_view>
#include <vector>

#include "symplant/tables/tables.hpp"

namespace symplant::panel {

/// By symbol, as the interface names it: `device`, `parts`, `follow`, `signal` or `none`. Valid for events. O(plant).
std::vector<std::string_view> drivers_of(const tables::PlantTables& tables);

}  // namespace symplant::panel

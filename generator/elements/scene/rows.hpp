// The panel's plan and 3D view as rows of generated code.
#pragma once

#include <string>
#include <string_view>

#include "model/plant_model.hpp"

namespace symplant::emit {

/// What each device looks like in the plan; empty if nothing suits any. O(length of all names).
std::string shape_rows(const model::PlantModel& plant);

/// A JSON text as string literals, a line each. O(text).
std::string json_rows(std::string_view json);

}  // namespace symplant::emit

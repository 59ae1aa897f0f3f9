// Requirements in words, for tables and pages.
#pragma once

#include <string>

#include "model/plant_model.hpp"

namespace symplant::view {

/// "never COND", or "after COND, expect COND within 5 s", or "... within 1 s to 5 s".
std::string requirement_text(const model::Requirement& requirement, const model::PlantModel& plant);

}  // namespace symplant::view

// Malfunctions in words, for tables and pages.
#pragma once

#include <string>

#include "model/plant_model.hpp"

namespace symplant::view {

/// "slower 3: L_P_D1, L_P_D2; when COND; by chance, 10 min; lasts 1 s; becomes `stuck` after 20 s unless COND".
/// O(what it names).
std::string malfunction_text(const model::Malfunction& malfunction, const model::PlantModel& plant);

}  // namespace symplant::view

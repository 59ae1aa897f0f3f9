// Rows of the malfunctions.
#pragma once

#include <string>

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

// Every function returns all rows of a table, without a line end after the last; nothing for an empty table. O(rows).
std::string malfunction_rows(const lower::EngineTables& tables);
std::string effect_rows(const lower::EngineTables& tables);
std::string malfunction_unit_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string malfunction_track_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string malfunction_force_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string malfunction_set_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
/// Enumerators of the malfunctions.
std::string malfunction_constant_rows(const model::PlantModel& plant);

}  // namespace symplant::emit

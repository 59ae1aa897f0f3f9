// Rows of conditions, watches and behaviors.
#pragma once

#include <string>

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

// Each function returns rows as the functions of rows.hpp do.
std::string condition_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string conditioned_unit_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string unit_watch_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string bit_watch_rows(const lower::EngineTables& tables, const model::PlantModel& plant,
                           tables::Direction direction);
std::string value_watch_rows(const lower::EngineTables& tables, const model::PlantModel& plant,
                             tables::Direction direction);
std::string overrun_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string behaviour_unit_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string behaviour_value_rows(const lower::EngineTables& tables, const model::PlantModel& plant);

}  // namespace symplant::emit

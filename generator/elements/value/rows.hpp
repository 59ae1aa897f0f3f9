// Rows of values, signals and comparisons.
#pragma once

#include <string>

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

std::string value_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string value_order_rows(const lower::EngineTables& tables);
std::string change_rows(const lower::EngineTables& tables);
std::string signal_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string formula_rows(const lower::EngineTables& tables);
std::string formula_step_rows(const lower::EngineTables& tables);
std::string formula_input_rows(const lower::EngineTables& tables);
std::string number_rows(const lower::EngineTables& tables);
std::string comparison_rows(const lower::EngineTables& tables);

}  // namespace symplant::emit

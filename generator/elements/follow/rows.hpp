// Rows of symbols that follow a condition.
#pragma once

#include <string>

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

std::string follow_rows(const lower::EngineTables& tables, const model::PlantModel& plant);

}  // namespace symplant::emit

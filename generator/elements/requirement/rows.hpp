// Rows of requirements.
#pragma once

#include <string>

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

std::string requirement_rows(const lower::EngineTables& tables, const model::PlantModel& plant);

}  // namespace symplant::emit

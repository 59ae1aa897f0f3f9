// The derived models for people.
#pragma once

#include <string>
#include <vector>

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::app {

/// The units named, each with its eight elements.
std::string model_table(const model::PlantModel& plant, const std::vector<std::uint32_t>& units);

/// "1 s", "500 ms".
std::string duration_text(core::Time time);

}  // namespace symplant::app

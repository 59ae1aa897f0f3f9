// The derived models for programs.
#pragma once

#include <string>
#include <vector>

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::app {

/// The version of the form; it changes where a reader of the old form would be misled.
inline constexpr int kModelJsonVersion = 1;

/// The units named, and every I/O symbol. Times are in nanoseconds.
std::string model_json(const model::PlantModel& plant, const lower::EngineTables& tables,
                       const std::vector<std::uint32_t>& units);

}  // namespace symplant::app

// Lowers the material flow.
#pragma once

#include <cstdint>
#include <functional>

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

/// Adds a condition of a row and returns its index.
using AddCondition = std::function<std::uint32_t(const condition::Tree& tree, tables::ReaderKind kind,
                                                 std::uint32_t row, std::uint8_t input)>;

/// Fills EngineTables::material except for its counters, and adds the random times of its sources.
void lower_material(const model::PlantModel& plant, const AddCondition& add_condition, EngineTables& tables);

}  // namespace symplant::lower

// Lowers conditions: truth tables, the symbols and units that they watch, and their readers.
#pragma once

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

/// Fills in conditions, watches and requirements. The rows of symbols must be complete. The conditions of units come
/// first, then those of requirements, then the inner tables of networks. O(n log n) in the atoms of the conditions.
void lower_conditions(const model::PlantModel& plant, EngineTables& tables);

}  // namespace symplant::lower

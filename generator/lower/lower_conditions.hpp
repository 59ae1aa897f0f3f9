// Conditions: truth tables, what they watch, who reads them.
#pragma once

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

/// Fills in conditions, watches and requirements, once the rows of symbols stand. The conditions of
/// units come first, then those of requirements, then the inner tables of networks. O(conditions' atoms * log).
void lower_conditions(const model::PlantModel& plant, EngineTables& tables);

}  // namespace symplant::lower

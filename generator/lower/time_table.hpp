// Lowers the times of transitions, fixed and random.
#pragma once

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

/// Fills Type::times, Transition::dt, Type::travel, UnitRow::times, EngineTables::times and random_times; types and
/// units must be complete. A time that is equal in all devices of a type belongs to the type. Other times are rows,
/// which devices with equal times share. O(devices * transitions).
void lower_times(const model::PlantModel& plant, EngineTables& tables);

}  // namespace symplant::lower

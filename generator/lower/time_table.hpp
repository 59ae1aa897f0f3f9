// Lowers the times of transitions, fixed and random.
#pragma once

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

/// Fills Type::times, Transition::dt, Type::travel, UnitRow::times, EngineTables::times and random_times; types and
/// units must be complete. A time in which all devices of a type agree is the type's; others are rows of the devices,
/// which devices of equal times share. O(devices, times transitions).
void lower_times(const model::PlantModel& plant, EngineTables& tables);

}  // namespace symplant::lower

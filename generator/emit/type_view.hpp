// The views of device types, for their classes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "emit/render.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

/// The class name of each type: the name from the description, else the device level without its digits. A number is
/// appended if different structures would share a name, in the order of their tasks and devices, not of rows.
std::vector<std::string> class_names(const lower::EngineTables& tables, const model::PlantModel& plant);

/// Views of all types, in their order. O(devices + states + transitions).
std::vector<View> type_views(const lower::EngineTables& tables, const model::PlantModel& plant,
                             const std::vector<std::string>& classes);

/// Lines for a list `devices`: the first twenty devices, and how many more there are.
std::vector<View> device_lines(const std::vector<std::uint32_t>& units, const model::PlantModel& plant);

}  // namespace symplant::emit

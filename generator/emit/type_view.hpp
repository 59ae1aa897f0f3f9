// A device type as its class shows it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "emit/render.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

/// The classes' names, a type each: the one that the description gives, else the device level without its digits;
/// numbered where structures differ.
std::vector<std::string> class_names(const lower::EngineTables& tables, const model::PlantModel& plant);

/// Views of all types, in their order. O(devices + states + transitions).
std::vector<View> type_views(const lower::EngineTables& tables, const model::PlantModel& plant,
                             const std::vector<std::string>& classes);

/// Lines about devices, for a list `devices`: the first twenty, and how many more there are.
std::vector<View> device_lines(const std::vector<std::uint32_t>& units, const model::PlantModel& plant);

}  // namespace symplant::emit

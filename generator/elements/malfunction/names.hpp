// The names of ordinary malfunctions, which every plant has without describing them.
#pragma once

#include <string_view>

#include "model/plant_names.hpp"

namespace symplant::model {

/// Whether a text is `UNIT stuck`, `UNIT slow`, `SYMBOL stuck on` or `SYMBOL stuck off`, of a BOOL input of the PLC.
bool is_ordinary_malfunction(std::string_view name, const PlantNames& names, const PlantModel& plant);

}  // namespace symplant::model

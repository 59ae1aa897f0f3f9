// The malfunctions of a plant.json.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "model/plant_model.hpp"
#include "property/files/said.hpp"

namespace symplant::property::files {

/// Makes the malfunctions such that a file can hold them.
void make_malfunctions_sayable(PlantText& plant);

/// The key `malfunctions`. Devices of `of` are written one by one or as patterns. `plant` has all devices.
nlohmann::json malfunctions_json(const description::Description& description, const model::PlantModel& plant,
                                 Sayer& sayer, Counts& counts);

}  // namespace symplant::property::files

// The plant's links as rows of generated code.
#pragma once

#include <string>

#include "model/plant_model.hpp"

namespace symplant::emit {

/// The links of the description: controller, URL.
std::string link_rows(const description::Description& description);

/// Arrays of what the settings point to: links::kPlaces0 and links::kKeep0 of controller 0.
std::string place_arrays(const model::PlantModel& plant);

/// The settings, a controller each; what is as link::LinkSettings has it is left out.
std::string link_settings_rows(const model::PlantModel& plant);

}  // namespace symplant::emit

// Which link of a plant a command reads, without writing to its PLC.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "model/plant_model.hpp"
#include "symplant/link/choice.hpp"
#include "symplant/link/link.hpp"

namespace symplant::app {

/// The one link of `--link` options, else that of the plant; it only reads. `command`: its name in messages.
std::variant<link::LinkChoice, link::LinkError> link_to_read(std::string_view command,
                                                             const std::vector<std::string>& links,
                                                             const model::PlantModel& plant,
                                                             const tables::PlantTables& tables);

}  // namespace symplant::app

// Checks the names in the plan and the 3D view of the panel.
#pragma once

#include "description/faults.hpp"
#include "model/plant_model.hpp"

namespace symplant::model {

/// Reports names in `plan` and `view3d` that the plant does not have, with the nearest existing name.
/// O(names + devices + locations + values), and all of these again for each name that is not found.
void check_scene(const PlantModel& plant, description::Faults& faults);

}  // namespace symplant::model

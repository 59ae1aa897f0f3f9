// Reads the plan and the 3D view of the panel.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "description/json_entry.hpp"
#include "elements/scene/given.hpp"

namespace symplant::description {

/// The members `plan` and `view3d` of a description that the schema has checked. O(their length).
GivenScene scene_of(const nlohmann::json& root, ShapeFaults& faults);

}  // namespace symplant::description

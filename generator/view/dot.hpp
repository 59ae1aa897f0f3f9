// State charts for Graphviz.
#pragma once

#include "view/scene.hpp"

namespace symplant::view {

/// One digraph with a cluster for each device: states, labeled arrows, and a note with the other facts. A dotted arrow
/// leads from a state to a device that it disables.
View dot_view(const Scene& scene);

}  // namespace symplant::view

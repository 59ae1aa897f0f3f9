// State charts for Graphviz.
#pragma once

#include "view/scene.hpp"

namespace symplant::view {

/// One digraph, a cluster a device: states, arrows with their labels, a note with all else; dotted arrows say who
/// disables whom.
View dot_view(const Scene& scene);

}  // namespace symplant::view

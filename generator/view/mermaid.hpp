// State charts for Mermaid (stateDiagram-v2), as Markdown pages show them.
#pragma once

#include "view/scene.hpp"

namespace symplant::view {

/// One diagram with a composite state for each device, and a note with the facts that the chart does not show.
View mermaid_view(const Scene& scene);

}  // namespace symplant::view

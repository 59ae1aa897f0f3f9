// State charts for Mermaid (stateDiagram-v2), as Markdown pages show them.
#pragma once

#include "view/scene.hpp"

namespace symplant::view {

/// One diagram, a composite state a device, with a note of all that a chart has no room for.
View mermaid_view(const Scene& scene);

}  // namespace symplant::view

// State charts as SCXML (W3C), for editors and simulators of state machines.
#pragma once

#include "view/scene.hpp"

namespace symplant::view {

/// One `<parallel>` with a region for each device. Attributes and elements of the namespace `urn:symplant:model:1` hold
/// what SCXML cannot express.
View scxml_view(const Scene& scene);

}  // namespace symplant::view

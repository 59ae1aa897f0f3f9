// State charts as a picture.
#pragma once

#include "view/scene.hpp"

namespace symplant::view {

/// Drawn by Graphviz if it is installed (Scene::programs), else by the built-in layout: a card for each device.
View svg_view(const Scene& scene);

}  // namespace symplant::view

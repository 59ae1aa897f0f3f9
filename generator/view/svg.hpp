// State charts as a picture.
#pragma once

#include "view/scene.hpp"

namespace symplant::view {

/// By Graphviz where it is installed (Scene::programs), else by a layout of the tool's own: a card a device.
View svg_view(const Scene& scene);

}  // namespace symplant::view

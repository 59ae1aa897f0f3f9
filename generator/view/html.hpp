// A model as one page for a browser.
#pragma once

#include "view/scene.hpp"

namespace symplant::view {

/// One file that needs nothing beside it and forbids its own way out.
View html_view(const Scene& scene);

}  // namespace symplant::view

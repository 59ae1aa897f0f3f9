// A model as one page for a browser.
#pragma once

#include "view/scene.hpp"

namespace symplant::view {

/// One self-contained file. Its content security policy forbids access to the network.
View html_view(const Scene& scene);

}  // namespace symplant::view

// A model as data for the HTML page: compact, each structure and each layout once.
#pragma once

#include <string>

#include "view/scene.hpp"

namespace symplant::view {

/// A JSON document for the inside of a `<script>` element. All texts in it are safe to show. O(the model).
std::string html_data(const Scene& scene);

}  // namespace symplant::view

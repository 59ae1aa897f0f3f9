// A model as data for the HTML page: compact, each structure and each layout once.
#pragma once

#include "base/text_source.hpp"
#include "view/scene.hpp"

namespace symplant::view {

/// Writes a JSON document for the inside of a `<script>` element. All texts in it are safe to show. O(the model).
void html_data(const Scene& scene, base::TextSink& sink);

}  // namespace symplant::view

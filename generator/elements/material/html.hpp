// The material flow as data for the HTML page.
#pragma once

#include "view/json_writer.hpp"
#include "view/scene.hpp"

namespace symplant::view {

/// The member `material` of the open object: the drawings of the locations shown, and the lists; nothing for a plant
/// without material. All texts in it are safe to show. O(material).
void write_page_material(const Scene& scene, JsonWriter& json);

}  // namespace symplant::view

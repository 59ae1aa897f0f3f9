// Values and the signal flow for the page.
#pragma once

#include <vector>

#include "view/json_writer.hpp"
#include "view/scene.hpp"

namespace symplant::view {

/// The member `values`: the values shown, all signals, and the drawing of the signal flow. Nothing if it is empty.
/// `unit_positions`: the index in the page of each unit; -1: it is not shown.
void write_page_values(const Scene& scene, const std::vector<int>& unit_positions, JsonWriter& json);

}  // namespace symplant::view

// The material flow in lines of text, for tables and notes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::view {

/// `1.5 m`, `20 mm`, `7 um`.
std::string length_text(std::int64_t micrometers);

/// One line for each track, place, transfer, work and source, and after that of a track or place, indented, one for
/// each of its drives, stops, sensors and ends. Empty without material. O(material).
std::vector<std::string> material_lines(const model::PlantModel& plant);

}  // namespace symplant::view

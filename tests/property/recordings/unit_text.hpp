// A unit and its part of a recording as text, to look into a wrong move.
#pragma once

#include <string>

#include "model/plant_model.hpp"
#include "recording/recording.hpp"

namespace symplant::property {

/// States, transitions with their times, and every change of its symbols from `begin` to `end`.
std::string unit_text(const model::PlantModel& plant, std::uint32_t unit, const recording::Recording& recording,
                      tables::Time begin, tables::Time end);

}  // namespace symplant::property

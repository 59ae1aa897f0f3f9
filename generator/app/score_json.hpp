// The score of a plant, for programs.
#pragma once

#include <string>

#include "model/plant_model.hpp"
#include "score/score.hpp"

namespace symplant::app {

/// An object on one line: the plant's file and its score on all levels (docs/checking.md, "The score").
std::string score_json(const std::string& file, const model::PlantModel& plant, const score::PlantScore& score);

}  // namespace symplant::app

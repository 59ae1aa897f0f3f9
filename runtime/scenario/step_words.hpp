// Describes the actions of a step in words.
#pragma once

#include <string>

#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::scenario {

/// The actions of a step for people: "set L_P_BTN_I_START on, start malfunction `eye blind`"; empty without actions.
/// The page has the same words in the past tense (act_words.js). O(actions).
std::string actions_words(const Step& step, const trace::PlantNames& names);

}  // namespace symplant::scenario

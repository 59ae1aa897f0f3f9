// Writes the actions of a step as JSON.
#pragma once

#include <string>

#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::scenario {

/// The members of a step without its time and expectation, as in a scenario file and without braces:
/// `"force":{"X":true},"release":["Y"]`. Reading them back gives the same actions. O(actions).
std::string actions_json(const Step& step, const trace::PlantNames& names);

/// The `act` of a line of a trace: the members except the operations that are set, in braces; empty if no member is
/// left.
std::string act_json(const Step& step, const trace::PlantNames& names);

}  // namespace symplant::scenario

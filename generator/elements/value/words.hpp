// Values and signals in words, for tables and differences.
#pragma once

#include <string>
#include <vector>

#include "model/plant_model.hpp"

namespace symplant::view {

/// "integral 2 * L_P_PUMP.RUN, from 0 to 120 l, starts at 20, each 10 ms".
std::string value_line(const model::Value& value, const model::PlantModel& plant);
/// "level [l]".
std::string value_title(const model::Value& value);
/// What a box of the signal flow shows below the title: the kind, its formula, each jump.
std::vector<std::string> value_box(const model::Value& value, const model::PlantModel& plant);
/// "level, from 0 to 120 as 0 to 27648, each 10 ms".
std::string signal_line(const model::Signal& signal, const model::PlantModel& plant);

}  // namespace symplant::view

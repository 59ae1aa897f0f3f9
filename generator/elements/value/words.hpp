// Values and signals in words, for tables and differences.
#pragma once

#include <string>

#include "model/plant_model.hpp"

namespace symplant::view {

/// "integral 2 * L_P_PUMP.RUN, from 0 to 120 l, starts at 20, each 10 ms".
std::string value_line(const model::Value& value, const model::PlantModel& plant);
/// "level, from 0 to 120 as 0 to 27648, each 10 ms".
std::string signal_line(const model::Signal& signal, const model::PlantModel& plant);

}  // namespace symplant::view

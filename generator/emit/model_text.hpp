// Texts for the comments of rows: transitions, conditions, readers of conditions. Names are not encoded yet.
#pragma once

#include <string>
#include <vector>

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

/// `d_ext(P1, O_P2) = P2`, `d_int(RUN2) = IDLE1`, `spring return: ADV to RET`.
std::string transition_text(const tables::Transition& transition, const model::Unit& unit,
                            const model::PlantModel& plant);

/// A condition in the syntax of descriptions (`L_P_AGV.P2 and not L_P_DOOR.OPEN1`), truncated if it is very long.
std::string short_condition_text(const condition::Tree& tree, const model::PlantModel& plant);

/// For each random time, the first transition that uses it.
std::vector<std::string> random_time_readers(const lower::EngineTables& tables, const model::PlantModel& plant);

/// For each condition, its reader, and the condition itself if it is not part of another one.
std::vector<std::string> condition_readers(const lower::EngineTables& tables, const model::PlantModel& plant);

}  // namespace symplant::emit

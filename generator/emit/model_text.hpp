// What rows cite in words: transitions, conditions, who reads them. As the user wrote the names: not encoded yet.
#pragma once

#include <string>
#include <vector>

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

/// `d_ext(P1, O_P2) = P2`, `d_int(RUN2) = IDLE1`, `the spring's own way: ADV to RET`.
std::string transition_text(const tables::Transition& transition, const model::Unit& unit,
                            const model::PlantModel& plant);

/// A condition as a description writes it (`L_P_AGV.P2 and not L_P_DOOR.OPEN1`), cut where it is very long.
std::string short_condition_text(const condition::Tree& tree, const model::PlantModel& plant);

/// Of each random time the first transition that it is of.
std::vector<std::string> random_time_readers(const lower::EngineTables& tables, const model::PlantModel& plant);

/// Of each condition who reads it, and the condition itself where it is no part of another.
std::vector<std::string> condition_readers(const lower::EngineTables& tables, const model::PlantModel& plant);

}  // namespace symplant::emit

// What a plant is, in a few lines for the one who starts it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "symplant/engine/behaviour.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::host {

/// The file names of the plant's symbol lists, with commas between; of many the first ones.
std::string lists_text(const tables::PlantTables& tables);

/// What was read, what can move, and what nobody moves. `more` are further lines, told behind the first. Numbers of a
/// device that one of `behaviours` serves are that one's to move.
std::string summary(const tables::PlantTables& tables, std::uint64_t model_hash,
                    const std::vector<std::string>& more = {}, std::span<const engine::Behaviour> behaviours = {});

/// A line for each behaviour that devices have and the program has no code for; nothing where there is none.
std::string absent_behaviours(const tables::PlantTables& tables, std::span<const engine::Behaviour> behaviours);

}  // namespace symplant::host

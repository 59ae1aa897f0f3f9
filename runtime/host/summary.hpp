// What a plant is, in a few lines for the one who starts it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/core/tables.hpp"

namespace symplant::host {

/// The file names of the plant's symbol lists, with commas between; of many the first ones.
std::string lists_text(const core::PlantTables& tables);

/// What was read, what can move, and what nobody moves. `more` are further lines, told behind the first.
std::string summary(const core::PlantTables& tables, std::uint64_t model_hash,
                    const std::vector<std::string>& more = {});

}  // namespace symplant::host

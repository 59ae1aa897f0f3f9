// The file of learned times, which plant.json includes.
#pragma once

#include <string>

#include "learn/learned.hpp"

namespace symplant::learn {

/// `{"symplant": 1, "times": {...}}`, with comments that say where each time is from. Equal recordings give equal
/// texts, whatever times the plant has.
std::string learned_file(const Learned& learned);

}  // namespace symplant::learn

// The forms in which pairs are shown and written.
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "learn/pairs.hpp"
#include "view/json_writer.hpp"

namespace symplant::learn {

/// "20 of 20 changes, after 0.35 s (0.3 s to 0.4 s); off: 20 of 20, after 0.1 s (...); by chance 1 of 20 at most".
std::string evidence(const Pair& pair);

/// Numbered pairs with their evidence, then fan-outs, interlocks, and what is to be done with them.
std::string pairs_text(const Pairs& pairs, const model::PlantModel& plant);

/// One value: an object with all pairs, fan-outs and interlocks.
void write_pairs(const Pairs& pairs, const model::PlantModel& plant, view::JsonWriter& json);

/// CSV that naming::read_links_file() reads, each row below a comment with its evidence. `refused`: indexes of pairs
/// that are left out. Pairs for which there is no row are comments.
std::string pairs_links(const Pairs& pairs, const model::PlantModel& plant, const std::set<std::size_t>& refused);

}  // namespace symplant::learn

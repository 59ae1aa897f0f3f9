// The score of a plant, for people.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "model/plant_model.hpp"
#include "score/score.hpp"

namespace symplant::app {

/// "of 23 BOOL I/O symbols 20 (87 %) paired, 23 (100 %) accounted for: 1 constant, 2 operator, 0 data", and
/// ", 4 sensors of parts", ", 1 by `follow`", ", 2 read by `material`, `values`, `follow` or `malfunctions`" if there
/// are any.
std::string score_text(const score::Counts& counts);

/// Rounded; 0 if `of` is 0.
std::size_t percent_of(std::size_t count, std::size_t of);

/// "match no rule": the reason that several symbols of an account have; empty if the account is not left over.
std::string_view reason_text(name::Account account);

/// The symbols that are left over, as lines; with `verbose` also the stations, and the events to ask about. Empty for
/// the built-in rule without `verbose`, because findings report each of its symbols.
std::string score_details(const model::PlantModel& plant, const score::PlantScore& score, bool verbose);

}  // namespace symplant::app

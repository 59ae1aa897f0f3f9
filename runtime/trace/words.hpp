// Short texts that messages about a run share: times, and names of symbols.
#pragma once

#include <cstdint>
#include <string>

#include "symplant/tables/time.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::trace {

/// `Y0001`, or the symbol's name if it has no address.
std::string address_or_name(std::uint32_t symbol, const PlantNames& names);

/// `since 1.5 s`, `since the start`.
std::string since_words(tables::Time changed);

/// ", written by program `cell` in scan 812 (8.12 s)" for an operation that changed at `time`; empty if no program
/// wrote it then. O(programs).
std::string written_words(std::uint32_t symbol, tables::Time time, const PlantNames& names);

/// Plant time in seconds: `1.5 s`.
std::string seconds(tables::Time time);

}  // namespace symplant::trace

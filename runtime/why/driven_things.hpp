// What an operation drives, in words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "symplant/trace/plant_names.hpp"
#include "symplant/why/symbol_use.hpp"

namespace symplant::why {

/// The name of what reads an operation, with its kind unless it is a device: "EXLINE_MB_AGV", "track CV1", "transfer
/// pick", "requirement one at a time"; of an event that follows a condition its symbol.
std::string reader_words(const SymbolReader& reader, const trace::PlantNames& names);

/// What an operation drives, each thing once: the device that it moves, then devices, tracks, transfers, work, sources,
/// events and malfunctions with a condition that reads it. A requirement only checks, so it is not among them.
/// O(readers^2). `with_malfunctions`: false leaves those out.
std::vector<std::string> driven_things(std::uint32_t operation, const SymbolUse& use, const trace::PlantNames& names,
                                       bool with_malfunctions = true);

}  // namespace symplant::why

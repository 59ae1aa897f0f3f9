// Symbols: their places in the planes, what they start from, what they follow.
#pragma once

#include <cstdint>
#include <vector>

#include "lower/bit_plane.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

/// Fills in the rows of symbols, once those of types and units stand; `symbol_bits` has the bits of units' symbols and
/// model::kNone for the others, which get theirs from the planes. O(symbols + events of units).
void lower_symbols(const model::PlantModel& plant, const std::vector<std::uint32_t>& symbol_bits, BitPlane& operations,
                   BitPlane& events, EngineTables& tables);

}  // namespace symplant::lower

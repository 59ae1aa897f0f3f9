// Lowers symbols: their slots in the planes, their initial values and the symbols that they follow.
#pragma once

#include <cstdint>
#include <vector>

#include "lower/bit_plane.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::lower {

/// Fills in the rows of symbols. The rows of types and units must be complete. `symbol_bits` has the bits of the units'
/// symbols and model::kNone for other symbols, which get a bit from the planes. O(symbols + events of units).
void lower_symbols(const model::PlantModel& plant, const std::vector<std::uint32_t>& symbol_bits, BitPlane& operations,
                   BitPlane& events, EngineTables& tables);

}  // namespace symplant::lower

// Pairs the symbols of two plants.
#pragma once

#include <array>
#include <vector>

#include "diff/difference.hpp"

namespace symplant::diff {

/// Which row of the old lists is which row of the new ones.
struct SymbolPairs {
  std::vector<std::vector<RowRef>> after;   ///< by old list and row: the row of the new plant, if it exists
  std::vector<std::vector<RowRef>> before;  ///< by new list and row
  std::array<std::size_t, 2> rows{};        ///< rows with a name: old, new

  const RowRef& after_of(const RowRef& old) const { return after[old.list][old.row]; }
};

/// Pairs rows with equal names, first those that also have equal addresses. Of the other rows it pairs those with equal
/// addresses, then those without an address that have equal types and comments, in both cases only if no other row has
/// the same. Rows without a name belong to no pair. Names of different controllers are different if both plants have
/// several. O(rows).
SymbolPairs pair_symbols(const model::PlantModel& before, const model::PlantModel& after);

std::vector<SymbolChange> symbol_changes(const model::PlantModel& before, const model::PlantModel& after,
                                         const SymbolPairs& pairs);

}  // namespace symplant::diff

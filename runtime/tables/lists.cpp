// Finds the list and the controller of a symbol.
#include "symplant/tables/lists.hpp"

#include <algorithm>

namespace symplant::tables {

std::uint32_t list_of(const PlantTables& tables, std::uint32_t symbol) noexcept {
  const auto next = std::upper_bound(
      tables.lists.begin(), tables.lists.end(), symbol,
      [](std::uint32_t wanted, const SymbolListRow& list) noexcept { return wanted < list.first_symbol; });
  return next == tables.lists.begin() ? 0 : static_cast<std::uint32_t>(next - tables.lists.begin() - 1);
}

std::uint32_t controller_of(const PlantTables& tables, std::uint32_t symbol) noexcept {
  return tables.lists.empty() ? 0 : tables.lists[list_of(tables, symbol)].controller;
}

}  // namespace symplant::tables

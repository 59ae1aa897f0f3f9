// Tables that contain only the sizes of the planes; tests fill in the rest.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/tables/tables.hpp"

namespace symplant::test {

inline tables::PlantTables bare_tables(std::string_view name, std::uint32_t operation_bits, std::uint32_t event_bits,
                                       std::uint32_t operation_slots = 0,
                                       std::span<const tables::SymbolRow> symbols = {}) {
  tables::PlantTables tables{};
  tables.name = name;
  tables.symbols = symbols;
  tables.operation_bits = operation_bits;
  tables.event_bits = event_bits;
  tables.operation_slots = operation_slots;
  return tables;
}

}  // namespace symplant::test

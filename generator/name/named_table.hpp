// A symbol list whose names have been read by a rule.
#pragma once

#include <string_view>
#include <vector>

#include "name/io_rows.hpp"
#include "name/symbol_reader.hpp"
#include "read/symbol_table.hpp"

namespace symplant::name {

/// `readings[i]` belongs to `table.rows[i]`. What does not fit the rule is not reported yet: internal symbols may have
/// any name.
struct NamedTable {
  const read::SymbolTable* table;
  std::vector<Reading> readings;
};

/// The table and the reader must outlive the result. `prefix` is put before the line of each device. Rows whose address
/// is in the PLC's memory are read only if `io` says that they are I/O. O(names and comments, and patterns for rows
/// that are internal or lack an address).
NamedTable read_names(const read::SymbolTable& table, SymbolReader& reader, std::string_view prefix = {},
                      IoRows* io = nullptr);

}  // namespace symplant::name

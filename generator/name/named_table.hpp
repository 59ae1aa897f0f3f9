// A symbol list whose names have been read by a rule.
#pragma once

#include <vector>

#include "name/name_parser.hpp"
#include "read/symbol_table.hpp"

namespace symplant::name {

/// `readings[i]` belongs to `table.rows[i]`. Faults are not reported yet: internal symbols may have any name.
struct NamedTable {
  const read::SymbolTable* table;
  const NamingRule* rule;
  std::vector<NameReading> readings;
};

/// The table and the rule must outlive the result. O(names).
NamedTable read_names(const read::SymbolTable& table, const NamingRule& rule);

}  // namespace symplant::name

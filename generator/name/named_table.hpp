// A symbol list whose names have been read by a rule.
#pragma once

#include <vector>

#include "name/name_parser.hpp"
#include "name/symbol_reader.hpp"
#include "read/symbol_table.hpp"

namespace symplant::name {

/// `readings[i]` belongs to `table.rows[i]`, or `by_rule[i]` under a custom rule; the other is empty. Faults are not
/// reported yet: internal symbols may have any name.
struct NamedTable {
  const read::SymbolTable* table;
  const NamingRule* rule;
  std::vector<NameReading> readings;
  std::vector<RuleReading> by_rule;
};

/// The table and the rule must outlive the result. O(names).
NamedTable read_names(const read::SymbolTable& table, const NamingRule& rule);

/// The same by a custom rule. The reader must outlive the result. Rows whose address is in the PLC's memory are not
/// read. O(names and comments).
NamedTable read_names(const read::SymbolTable& table, SymbolReader& reader);

}  // namespace symplant::name

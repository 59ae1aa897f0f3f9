// Reads every name of a list.
#include "name/named_table.hpp"

#include "base/large_memory.hpp"

namespace symplant::name {

NamedTable read_names(const read::SymbolTable& table, const NamingRule& rule) {
  NamedTable named{&table, &rule, {}};
  base::reserve_large(named.readings, table.rows.size());
  NameParser parser(rule);
  for (const read::ListRow& row : table.rows) named.readings.push_back(parser.parse(row.name));
  return named;
}

}  // namespace symplant::name

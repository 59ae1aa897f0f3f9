// Reads every name of a list.
#include "name/named_table.hpp"

namespace symplant::name {

NamedTable read_names(const read::SymbolTable& table, const NamingRule& rule) {
  NamedTable named{&table, &rule, {}};
  named.readings.reserve(table.rows.size());
  NameParser parser(rule);
  for (const read::ListRow& row : table.rows) named.readings.push_back(parser.parse(row.name));
  return named;
}

}  // namespace symplant::name

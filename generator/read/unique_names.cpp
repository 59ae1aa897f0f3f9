// Names of variables that several programs or lists declare.
#include "read/unique_names.hpp"

#include <string>

#include "text/ascii.hpp"

namespace symplant::read {

namespace {

/// Longer scopes are not put in front of names: no tool has them, and many copies must not fill the memory.
constexpr std::size_t kLongestScope = 255;

}  // namespace

void qualify_repeated_names(TableBuilder& builder) {
  SymbolTable& table = builder.table();
  text::ByName<std::size_t> count_of;
  count_of.reserve(table.rows.size());
  for (const ListRow& row : table.rows) ++count_of[row.name];
  if (count_of.size() == table.rows.size()) return;
  std::size_t changed = 0;
  for (ListRow& row : table.rows) {
    const std::string_view scope = table.extra_of(row).scope;
    if (scope.empty() || scope.size() > kLongestScope || count_of[row.name] < 2) continue;
    row.name = builder.keep(std::string(scope).append(".").append(row.name));
    ++changed;
  }
  if (changed != 0) {
    builder.decide("names that are declared several times: " + std::to_string(changed) +
                   " rows have the name of their program or list in front, `PROGRAM.NAME`");
  }
}

}  // namespace symplant::read

// Reads every name of a list.
#include "name/named_table.hpp"

#include <optional>

#include "address/address.hpp"
#include "address/notation.hpp"
#include "base/large_memory.hpp"

namespace symplant::name {

namespace {

/// The area of a row's address; nothing without one. The radix of X and Y makes no difference.
std::optional<address::Area> area_of(const read::ListRow& row, const address::Dialect& dialect) {
  auto address = address::parse_iec(row.iec_address);
  if (!address && row.vendor_address.empty()) address = address::parse(row.iec_address, dialect);
  if (!address) address = address::parse(row.vendor_address, dialect);
  if (!address) address = address::parse_iec(row.vendor_address);
  return address ? std::optional(address->area) : std::nullopt;
}

}  // namespace

NamedTable read_names(const read::SymbolTable& table, const NamingRule& rule) {
  NamedTable named{&table, &rule, {}, {}};
  base::reserve_large(named.readings, table.rows.size());
  NameParser parser(rule);
  for (const read::ListRow& row : table.rows) named.readings.push_back(parser.parse(row.name));
  return named;
}

NamedTable read_names(const read::SymbolTable& table, SymbolReader& reader) {
  NamedTable named{&table, &built_in_rule(), {}, {}};
  base::reserve_large(named.by_rule, table.rows.size());
  const address::Dialect dialect{table.notation, address::Radix::hexadecimal, &table.io_words};
  for (const read::ListRow& row : table.rows) {
    const auto area = area_of(row, dialect);
    if (area == address::Area::memory) {
      named.by_rule.emplace_back();
      continue;
    }
    std::optional<Side> side;
    if (area) side = *area == address::Area::output ? Side::operation : Side::event;
    named.by_rule.push_back(reader.read({row.name, row.comment, table.extra_of(row).parent_comment, side}));
  }
  return named;
}

}  // namespace symplant::name

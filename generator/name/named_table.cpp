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

NamedTable read_names(const read::SymbolTable& table, SymbolReader& reader, std::string_view prefix, IoRows* io) {
  NamedTable named{&table, {}};
  base::reserve_large(named.readings, table.rows.size());
  const address::Dialect dialect{table.notation, address::Radix::hexadecimal, &table.io_words};
  for (const read::ListRow& row : table.rows) {
    const auto area = area_of(row, dialect);
    const bool is_internal = !area || area == address::Area::memory;
    std::optional<Direction> given;
    if (io != nullptr && is_internal) given = io->direction_of(row.name, row.vendor_address, row.iec_address);
    if (area == address::Area::memory && !given) {
      named.readings.emplace_back();
      continue;
    }
    std::optional<Direction> side = given;
    if (!is_internal) side = *area == address::Area::output ? Direction::operation : Direction::event;
    named.readings.push_back(reader.read({row.name, row.comment, table.extra_of(row).parent_comment, side, prefix}));
    named.readings.back().given_io = given.has_value();
    named.readings.back().given_direction = given.value_or(Direction::event);
  }
  return named;
}

}  // namespace symplant::name

// Reads every name of a list.
#include "name/named_table.hpp"

#include <optional>

#include "address/address.hpp"
#include "address/notation.hpp"
#include "base/large_memory.hpp"

namespace symplant::name {

namespace {

/// A row's address; nothing without one. The radix of X and Y makes no difference to its area.
std::optional<address::Address> address_of(const read::ListRow& row, const address::Dialect& dialect) {
  auto address = address::parse_iec(row.iec_address);
  if (!address && row.vendor_address.empty()) address = address::parse(row.iec_address, dialect);
  if (!address) address = address::parse(row.vendor_address, dialect);
  if (!address) address = address::parse_iec(row.vendor_address);
  return address;
}

bool says_operation(const Reading& reading) {
  return reading.is_read() && reading.direction_of_name == Direction::operation;
}

}  // namespace

NamedTable read_names(const read::SymbolTable& table, SymbolReader& reader, std::string_view prefix, IoRows* io) {
  NamedTable named{&table, {}};
  base::reserve_large(named.readings, table.rows.size());
  const address::Dialect dialect{table.notation, address::Radix::hexadecimal, &table.io_words};
  for (const read::ListRow& row : table.rows) {
    const auto address = address_of(row, dialect);
    const auto area = address ? std::optional(address->area) : std::nullopt;
    const bool is_internal = !area || area == address::Area::memory;
    SymbolText text{row.name, row.comment, table.extra_of(row).parent_comment, {}, prefix};
    std::optional<Direction> given;
    if (io != nullptr && is_internal) given = io->direction_of(row.name, row.vendor_address, row.iec_address);
    if (address && address->bank == address::kHoldingRegisters && !given && says_operation(reader.read(text))) {
      given = Direction::operation;  // 40001 is memory, unless a name says that the PLC writes it
    }
    if (area == address::Area::memory && !given) {
      named.readings.emplace_back();
      continue;
    }
    std::optional<Direction> side = given;
    if (!is_internal) side = *area == address::Area::output ? Direction::operation : Direction::event;
    text.address = side;
    named.readings.push_back(reader.read(text));
    named.readings.back().given_io = given.has_value();
    named.readings.back().given_direction = given.value_or(Direction::event);
  }
  return named;
}

}  // namespace symplant::name

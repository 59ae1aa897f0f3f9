// The block of numbers that a PLC transfers cyclically, gaps included.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "symplant/link/modbus/io_map.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::modbus {

/// Numbers of a table.
struct NumberRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;

  std::uint32_t end() const noexcept { return first + count; }
  bool operator==(const NumberRange&) const = default;
};

/// The most numbers of a table that OpenPLC transfers from and to all its slave devices.
inline constexpr std::uint32_t kMostOfOpenPlc = 400;

/// The numbers of a table that the slave devices of `symplant map --format openplc` transfer for its symbols: one
/// range, without a gap between the devices. If possible, it starts so that the symbols keep the addresses of the list.
/// Gaps within the range belong to the map: a PLC may write them. Longer than OpenPLC allows if the symbols do not fit.
/// Nothing if the table has no symbols. O(symbols log symbols).
std::optional<NumberRange> openplc_range(const tables::PlantTables& tables, const IoMap& map, Table table);

/// As openplc_range(); nothing if OpenPLC cannot transfer that range.
std::optional<NumberRange> transfer_range(const tables::PlantTables& tables, const IoMap& map, Table table);

/// The registers of the status block or the watchdog, which OpenPLC transfers in another block than the symbols.
std::uint32_t extra_numbers(const IoMap& map, Table table);

/// The points of a table, sorted by number. O(symbols log symbols).
std::vector<const IoPoint*> points_of(const IoMap& map, Table table);

/// The difference between the addresses of these points in the list, counted as numbers, and their numbers on the link.
/// Nothing if no point has such an address, or if the differences are not all the same. O(points).
std::optional<std::int64_t> listed_offset(const tables::PlantTables& tables, std::span<const IoPoint* const> points);

}  // namespace symplant::link::modbus

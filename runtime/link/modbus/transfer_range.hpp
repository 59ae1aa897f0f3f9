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

/// The numbers of a table that the slave devices of `symplant map --format openplc` transfer for its symbols: without a
/// gap between them, and begun so that the symbols keep the addresses of the list, if possible. Gaps within it belong
/// to the map: a PLC that writes them makes no error. Longer than OpenPLC allows if the symbols do not fit. Nothing if
/// the table has no symbols. O(symbols log symbols).
std::optional<NumberRange> openplc_range(const tables::PlantTables& tables, const IoMap& map, Table table);

/// As openplc_range(), if OpenPLC can transfer it.
std::optional<NumberRange> transfer_range(const tables::PlantTables& tables, const IoMap& map, Table table);

/// The registers of the status block or the watchdog, which OpenPLC transfers in another block than the symbols.
std::uint32_t extra_numbers(const IoMap& map, Table table);

/// The points of a table, sorted by number. O(symbols log symbols).
std::vector<const IoPoint*> points_of(const IoMap& map, Table table);

/// How much the addresses that the list gives to these points, counted as numbers, are above their numbers on the link.
/// Nothing if it gives none or if they differ. O(points).
std::optional<std::int64_t> listed_offset(const tables::PlantTables& tables, std::span<const IoPoint* const> points);

}  // namespace symplant::link::modbus

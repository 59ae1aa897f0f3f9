// The block of numbers that a PLC transfers cyclically, gaps included.
#include "symplant/link/modbus/transfer_range.hpp"

#include <algorithm>

namespace symplant::link::modbus {

namespace {

constexpr std::uint32_t kFirst = 100;  ///< the byte or word of OpenPLC that the first number of its slave devices is
constexpr std::uint32_t kByte = 8;

/// The first number, so that the symbols have the addresses that the list gives them; else 0, or the lowest number if 0
/// is too far below the last.
std::uint32_t start_of(const tables::PlantTables& tables, Table table, const std::vector<const IoPoint*>& points,
                       std::uint32_t end, std::uint32_t room) {
  const std::uint32_t base = kFirst * (has_bits(table) ? kByte : 1);
  const std::uint32_t lowest = points.front()->number;
  const auto offset = listed_offset(tables, points);
  const std::int64_t start = offset ? base - *offset : -1;
  if (start >= 0 && start <= lowest && end - start <= room) return static_cast<std::uint32_t>(start);
  if (end <= room) return 0;
  return has_bits(table) ? lowest / kByte * kByte : lowest;
}

}  // namespace

std::uint32_t extra_numbers(const IoMap& map, Table table) {
  if (table == Table::input_register) return map.status_block ? kStatusWords : 0;
  return table == Table::holding_register && map.watchdog ? 1 : 0;
}

std::vector<const IoPoint*> points_of(const IoMap& map, Table table) {
  std::vector<const IoPoint*> points;
  for (const IoPoint& point : map.points) {
    if (point.table == table) points.push_back(&point);
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const IoPoint* a, const IoPoint* b) { return a->number < b->number; });
  return points;
}

std::optional<std::int64_t> listed_offset(const tables::PlantTables& tables, std::span<const IoPoint* const> points) {
  std::optional<std::int64_t> offset;
  for (const IoPoint* const point : points) {
    const tables::SymbolRow& symbol = tables.symbols[point->symbol];
    const std::uint32_t own = is_8_bits(symbol.type()) ? tables::kNone : own_number(symbol);
    if (own == tables::kNone) continue;
    const std::int64_t this_offset = std::int64_t{own} - point->number;
    if (offset && *offset != this_offset) return std::nullopt;
    offset = this_offset;
  }
  return offset;
}

std::optional<NumberRange> openplc_range(const tables::PlantTables& tables, const IoMap& map, Table table) {
  const auto points = points_of(map, table);
  if (points.empty()) return std::nullopt;
  std::uint32_t end = 0;
  for (const IoPoint* const point : points) end = std::max(end, point->last() + 1);
  const std::uint32_t start = start_of(tables, table, points, end, kMostOfOpenPlc - extra_numbers(map, table));
  return NumberRange{start, end - start};
}

std::optional<NumberRange> transfer_range(const tables::PlantTables& tables, const IoMap& map, Table table) {
  const auto range = openplc_range(tables, map, table);
  const bool fits = range && range->count + extra_numbers(map, table) <= kMostOfOpenPlc;
  return fits ? range : std::nullopt;
}

}  // namespace symplant::link::modbus

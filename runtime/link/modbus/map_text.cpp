// The texts of a map and its digest.
#include <algorithm>
#include <string_view>
#include <tuple>

#include "symplant/link/modbus/io_map.hpp"
#include "symplant/tables/ascii.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::link::modbus {

namespace {

/// The symbol's name in back-ticks; `texts` has two entries for each symbol, name and address.
std::string quoted(const std::vector<std::string_view>& texts, std::uint32_t symbol) {
  const std::size_t at = std::size_t{symbol} * 2;
  return "`" + (at < texts.size() ? std::string(texts[at]) : std::string()) + "`";
}

const IoPoint* point_of(const IoMap& map, std::uint32_t symbol) {
  const auto found =
      std::find_if(map.points.begin(), map.points.end(), [&](const IoPoint& point) { return point.symbol == symbol; });
  return found == map.points.end() ? nullptr : &*found;
}

/// "holding register 7", "holding registers 10 to 11".
std::string address_text(const IoPoint& point) {
  const std::string name = table_name(point.table);
  if (point.width == 1) return name + " " + std::to_string(point.number);
  return name + "s " + std::to_string(point.number) + " to " + std::to_string(point.last());
}

std::string size_text(const IoMap& map, Table table) {
  const std::uint32_t size = map.sizes[static_cast<std::size_t>(table)];
  return std::string(table_name(table)) + "s have the size " + std::to_string(size);
}

}  // namespace

std::string fault_text(const tables::PlantTables& tables, const IoMap& map, const MapFault& fault) {
  const std::vector<std::string_view> texts = tables::split_names(tables.symbol_names);
  const IoPoint* const point = point_of(map, fault.symbol);  // null if it is not a symbol
  const std::string name = quoted(texts, fault.symbol);
  const std::string address = point == nullptr ? "" : address_text(*point);
  switch (fault.kind) {
    case MapFault::Kind::overlap: {
      const IoPoint* const other = point_of(map, fault.other);
      return name + " on " + address + " and " + quoted(texts, fault.other) + " on " +
             (other == nullptr ? "" : address_text(*other)) +
             " overlap: give one of them another number, in the list or in `links`";
    }
    case MapFault::Kind::beyond_end:
      return name + " would end above address 65535, the highest in Modbus: give it a lower number";
    case MapFault::Kind::beyond_size:
      return name + " is on " + address + ", but the " + size_text(map, point->table) +
             ": give them a larger `size`, or the symbol a lower number";
    case MapFault::Kind::status_overlap:
      return "the status block from input register " + std::to_string(*map.status_block) + " on overlaps " + name +
             " on " + address + ": give `status` another register, or `\"off\"`";
    case MapFault::Kind::status_beyond:
      return "the status block has 12 registers and does not fit from input register " + std::to_string(fault.symbol) +
             " on, since the last one is " + std::to_string(fault.other - 1) +
             ": give `status` a lower register, or `\"off\"`";
    case MapFault::Kind::watchdog_overlap:
      return "the watchdog on holding register " + std::to_string(*map.watchdog) + " overlaps " + name + " on " +
             address + ": give `watchdog` another register";
    case MapFault::Kind::watchdog_beyond:
      return "the watchdog is on holding register " + std::to_string(fault.symbol) + ", but the last one is " +
             std::to_string(fault.other - 1) + ": give `watchdog` a lower register";
  }
  return {};
}

std::vector<Unreachable> unreachable_symbols(const IoMap& map) {
  std::vector<Unreachable> unreachable;
  for (const std::uint32_t symbol : map.excluded) unreachable.push_back({symbol, "is excluded from the link"});
  for (const std::uint32_t symbol : map.without_address) unreachable.push_back({symbol, "has no address"});
  for (const std::uint32_t symbol : map.of_8_bits) {
    unreachable.push_back({symbol, "has 8 bits: give it a register by a `symbol` entry in `links`"});
  }
  for (const std::uint32_t symbol : map.too_many) unreachable.push_back({symbol, "is beyond the 65,536 of its table"});
  return unreachable;
}

std::string range_text(std::string_view name, std::uint32_t first, std::uint32_t count) {
  std::string text(name);
  if (count == 1) return text + " " + std::to_string(first);
  return text + "s " + std::to_string(first) + "-" + std::to_string(first + count - 1);
}

std::string location_text(const IoPoint& point) {
  return range_text(table_name(point.table), point.number, point.width);
}

std::uint64_t map_hash(const tables::PlantTables& tables, const IoMap& map) {
  const std::vector<std::string_view> texts = tables::split_names(tables.symbol_names);
  const auto name_of = [&](const IoPoint& point) { return tables::to_upper(texts[std::size_t{point.symbol} * 2]); };
  std::vector<std::uint32_t> order(map.points.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const IoPoint& one = map.points[a];
    const IoPoint& other = map.points[b];
    const auto key = std::tuple(one.table, one.number);
    const auto other_key = std::tuple(other.table, other.number);
    return key != other_key ? key < other_key : name_of(one) < name_of(other);
  });

  constexpr std::uint32_t kLayout = 1;  ///< version of the digested data
  tables::Fnv1a64 hash;
  hash.u32(kLayout);
  for (const std::uint32_t size : map.sizes) hash.u32(size);
  for (const std::uint32_t i : order) {
    const IoPoint& point = map.points[i];
    hash.byte(static_cast<std::uint8_t>(point.table));
    hash.u32(point.number);
    hash.byte(static_cast<std::uint8_t>(tables.symbols[point.symbol].type()));
    hash.byte(point.width == 1 ? 0 : static_cast<std::uint8_t>(point.word_order));
    for (const char c : name_of(point)) hash.byte(static_cast<std::uint8_t>(c));
    hash.byte(0);
  }
  hash.u32(map.status_block ? *map.status_block : kNowhere);
  hash.u32(map.watchdog ? *map.watchdog : kNowhere);
  return hash.value();
}

}  // namespace symplant::link::modbus

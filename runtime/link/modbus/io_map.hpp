// The I/O map of Modbus: the table and number of each symbol.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symplant/link/image/map.hpp"
#include "symplant/link/image/numbers.hpp"
#include "symplant/link/link_map.hpp"
#include "symplant/link/link_settings.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::modbus {

/// The four tables of Modbus, one for each plane of an image, in the same order.
enum class Table : std::uint8_t {
  coil,              ///< bit operations
  discrete_input,    ///< bit events
  holding_register,  ///< numeric operations
  input_register,    ///< numeric events
};
inline constexpr std::size_t kTables = kPlanes;

constexpr Plane plane_of(Table table) noexcept { return static_cast<Plane>(table); }
constexpr Table table_of(Plane plane) noexcept { return static_cast<Table>(plane); }
constexpr bool has_bits(Table table) noexcept { return link::has_bits(plane_of(table)); }
constexpr bool is_event(Table table) noexcept { return link::is_event(plane_of(table)); }

/// A symbol's table and number. Several symbols of one address have the same.
struct IoPoint {
  std::uint32_t symbol;
  Table table;
  std::uint32_t number;  ///< protocol address, counted from 0; the first of several registers
  std::uint8_t width;    ///< coils or registers: 1; a number of 32 bits takes 2 registers, one of 64 bits 4
  WordOrder word_order;  ///< which of several registers comes first
  OnLoss on_loss;        ///< of operations

  std::uint32_t last() const noexcept { return number + width - 1; }
};

/// Why a map is invalid: an overlap, or something beyond the end of a table.
struct MapFault {
  enum class Kind : std::uint8_t {
    overlap,           ///< two symbols, `symbol` and `other`
    beyond_end,        ///< `symbol` ends above address 65,535
    beyond_size,       ///< `symbol` is beyond the configured size of its table
    status_overlap,    ///< the status block and `symbol`
    status_beyond,     ///< the status block from register `symbol` on ends beyond the table, which ends before `other`
    watchdog_overlap,  ///< the watchdog and `symbol`
    watchdog_beyond,   ///< the watchdog on register `symbol` is beyond the table, which ends before `other`
  };
  Kind kind = Kind::overlap;
  std::uint32_t symbol = 0;
  std::uint32_t other = 0;
};

struct IoMap {
  std::vector<IoPoint> points;                     ///< in the order of the symbol list
  std::array<std::uint32_t, kTables> sizes{};      ///< as set; else highest number + 1, rounded up to a multiple of 16
  std::array<bool, kTables> packed{};              ///< numbers are positions, not addresses: some address did not fit
  std::optional<std::uint32_t> status_block;       ///< its first input register; it has kStatusWords
  WordOrder status_order = WordOrder::high_first;  ///< of the numbers in the status block
  bool no_room_for_status = false;                 ///< there is no block, since there is no room above the map
  std::optional<std::uint32_t> watchdog;           ///< its holding register
  std::vector<std::uint32_t> excluded;             ///< symbols that the settings leave out
  std::vector<std::uint32_t> without_address;      ///< symbols on no link, since they have no address
  std::vector<std::uint32_t> of_8_bits;  ///< numeric symbols of 8 bits without a number in the settings: on no link
  std::vector<std::uint32_t> too_many;   ///< symbols beyond the 65,536 addresses of a table
  std::vector<MapFault> faults;          ///< empty in a map that a link can be opened with
};

/// The map of one controller's symbols, which is what a link carries. A symbol's number comes from its settings, else
/// from its address, counted in registers (%ID5 takes 10 and 11). If one symbol of a table has neither, or one above
/// 65535, all symbols of that table without a number in the settings are packed in list order instead. By default the
/// status block is at the first multiple of 100 above the highest number of all tables (100 if they are empty).
/// O(symbols + addresses).
IoMap make_io_map(const tables::PlantTables& tables, std::uint32_t controller, const LinkSettings& settings);

/// "`A` on holding register 11 and `B` on ... overlap: ...": what is wrong and what to do.
std::string fault_text(const tables::PlantTables& tables, const IoMap& map, const MapFault& fault);

/// The symbols that the map leaves out.
std::vector<Unreachable> unreachable_symbols(const IoMap& map);

/// "coil 5", "holding registers 10-11": `count` addresses of a table whose addresses are called `name`.
std::string range_text(std::string_view name, std::uint32_t first, std::uint32_t count);
std::string location_text(const IoPoint& point);

/// FNV-1a 64 digest of everything in the map that a PLC program depends on: sizes of the tables; table, number, type,
/// word order and name of each symbol, without regard to the case of ASCII letters; status block and watchdog. The
/// order of the symbols in the lists does not matter. O(symbols log symbols).
std::uint64_t map_hash(const tables::PlantTables& tables, const IoMap& map);

/// Whether a number of this type fills half a register.
constexpr bool is_8_bits(tables::DataType type) noexcept { return image::bits_of(type) == 8; }

/// The number that a symbol's own address gives it, counted in registers; tables::kNone if it has none below 65536.
std::uint32_t own_number(const tables::SymbolRow& symbol);

/// The Modicon number of a protocol address, counted from 1 and written with its table's digit: coil 0 is 1, discrete
/// input 1 is 10002; six digits from number 10,000 on (110001).
std::uint32_t modicon_number(Table table, std::uint32_t number);

const char* table_name(Table table);

/// Where a map lies in the images of a link: bits at their numbers, so that ranges of coils are ranges of bits; the
/// numbers of a table in the order of their registers, then the status. The points are in the order of `map.points`.
/// O(points log points).
image::Map image_of(const tables::PlantTables& tables, const IoMap& map);

inline constexpr std::uint32_t kNoLane = 0xFFFF'FFFF;

/// By register of a table: its lane in the numbers of the image `placed`, which image_of() made of `map`; kNoLane if
/// neither a symbol nor the status has it. O(size of the table).
std::vector<std::uint32_t> lanes_of(const IoMap& map, const image::Map& placed, Table table);

}  // namespace symplant::link::modbus

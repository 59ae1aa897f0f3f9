// The I/O map: the table and number of each symbol on a link.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "symplant/link/link_settings.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link {

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
  std::vector<IoPoint> points;                 ///< in the order of the symbol list
  std::array<std::uint32_t, kTables> sizes{};  ///< as set; else highest number + 1, rounded up to a multiple of 16
  std::array<bool, kTables> packed{};          ///< numbers are positions, not addresses: some address did not fit
  std::optional<std::uint32_t> status_block;   ///< its first input register; it has kStatusRegisters
  bool no_room_for_status = false;             ///< there is no block, since there is no room above the map
  std::optional<std::uint32_t> watchdog;       ///< its holding register
  std::vector<std::uint32_t> excluded;         ///< symbols that the settings leave out
  std::vector<std::uint32_t> without_address;  ///< symbols on no link, since they have no address
  std::vector<std::uint32_t> of_8_bits;  ///< numeric symbols of 8 bits without a number in the settings: on no link
  std::vector<std::uint32_t> too_many;   ///< symbols beyond the 65,536 addresses of a table
  std::vector<MapFault> faults;          ///< empty in a map that a link can be opened with
};

/// Number of registers of the status block.
inline constexpr std::uint32_t kStatusRegisters = 12;

/// The map of one controller's symbols, which is what a link carries. A symbol's number comes from its settings, else
/// from its address, counted in registers (%ID5 takes 10 and 11). If one symbol of a table has neither, or one above
/// 65535, all symbols of that table without a number in the settings are packed in list order instead. By default the
/// status block is at the first multiple of 100 above the highest number of all tables (100 if they are empty).
/// O(symbols + addresses).
IoMap make_io_map(const tables::PlantTables& tables, std::uint32_t controller, const LinkSettings& settings);

/// "`A` on holding register 11 and `B` on ... overlap: ...": what is wrong and what to do.
std::string fault_text(const tables::PlantTables& tables, const IoMap& map, const MapFault& fault);

/// What operations do while the link is lost: "hold", "go to zero", "hold, 2 of 3 go to zero". O(symbols).
std::string loss_words(const IoMap& map);

/// FNV-1a 64 digest of everything in the map that a PLC program depends on: sizes of the tables; table, number, type,
/// word order and name of each symbol, without regard to the case of ASCII letters; status block and watchdog. The
/// order of the symbols in the lists does not matter. O(symbols log symbols).
std::uint64_t map_hash(const tables::PlantTables& tables, const IoMap& map);

/// Whether a number of this type fills half a register.
bool is_8_bits(tables::DataType type);

/// Number of registers that a number of this type takes; 1 for BOOL and for 8 bits.
std::uint8_t width_of(tables::DataType type) noexcept;

/// The number that a symbol's own address gives it, counted in registers; tables::kNone if it has none below 65536.
std::uint32_t own_number(const tables::SymbolRow& symbol);

/// The Modicon number of a protocol address, counted from 1 and written with its table's digit: coil 0 is 1, discrete
/// input 1 is 10002; six digits from number 10,000 on (110001).
std::uint32_t modicon_number(Table table, std::uint32_t number);

const char* table_name(Table table);

}  // namespace symplant::link

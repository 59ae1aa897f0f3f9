// Which symbol stands where on a link: the I/O map.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "symplant/link/link_settings.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link {

/// A symbol's place. Several symbols of one address have the same place.
struct IoPoint {
  std::uint32_t symbol;
  Table table;
  std::uint16_t number;  ///< protocol address, counted from 0; of several registers the first
  std::uint8_t places;   ///< 1; a number of 32 bits takes 2 registers, one of 64 bits 4
  WordOrder word_order;  ///< which of them comes first
  OnLoss on_loss;        ///< of operations

  std::uint32_t last() const noexcept { return std::uint32_t{number} + places - 1; }
};

/// Why a map cannot be: what stands where something else does, or beyond the end.
struct MapFault {
  enum class Kind : std::uint8_t {
    overlap,           ///< two symbols, `symbol` and `other`
    beyond_end,        ///< `symbol` ends behind place 65,535
    beyond_size,       ///< `symbol` stands beyond the size that the table was given
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
  std::optional<std::uint32_t> status_block;   ///< its first input register, of kStatusRegisters
  bool no_room_for_status = false;             ///< it was to stand above the map, and there is no room: there is none
  std::optional<std::uint32_t> watchdog;       ///< its holding register
  std::vector<std::uint32_t> without_address;  ///< symbols on no link, for want of an address
  std::vector<std::uint32_t> of_8_bits;        ///< numeric symbols of 8 bits whose place nobody says: on no register
  std::vector<std::uint32_t> too_many;         ///< symbols beyond the 65,536 places of a table
  std::vector<MapFault> faults;                ///< none in a map that a link may be opened with
};

/// The registers of the status block.
inline constexpr std::uint32_t kStatusRegisters = 12;

/// The map of one controller's symbols, which is what a link carries. A symbol's number is the one its settings give
/// it; else its address's own, counted in registers (%ID5 takes 10 and 11); where one symbol of a table has neither, or
/// one beyond 65535, all of that table whose number is not given are packed in list order instead. The status block
/// stands by default on the first multiple of 100 above the highest number of all tables (100 where there is none).
/// O(symbols + places).
IoMap make_io_map(const tables::PlantTables& tables, std::uint32_t controller, const LinkSettings& settings);

/// "`A` and `B` both stand on holding register 11: ...", what is wrong and what to do.
std::string fault_text(const tables::PlantTables& tables, const IoMap& map, const MapFault& fault);

/// What operations do while the link is lost: "hold", "go to zero", "hold, 2 of 3 go to zero". O(places).
std::string loss_words(const IoMap& map);

/// Digest of all that the PLC's programmer has to know of the map, FNV-1a 64: the tables' sizes; of each place its
/// table, number, type, word order and the symbol's name without regard to the case of ASCII letters; status block and
/// watchdog. In which order the lists have the symbols does not count. O(symbols log symbols).
std::uint64_t map_hash(const tables::PlantTables& tables, const IoMap& map);

/// Registers that a number of this type takes; 1 of BOOL and of 8 bits.
std::uint8_t places_of(tables::DataType type) noexcept;

/// The Modicon number of a place, counted from 1 and written with its table's digit: coil 0 is 1, discrete input 1 is
/// 10002; from 10,000 places on with six digits (110001).
std::uint32_t modicon_number(Table table, std::uint16_t number);

const char* table_name(Table table);

}  // namespace symplant::link

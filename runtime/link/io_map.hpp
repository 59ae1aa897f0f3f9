// Which symbol stands where on a link: the default I/O map.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "symplant/core/tables.hpp"
#include "symplant/link/link_settings.hpp"

namespace symplant::link {

/// A symbol's place. Several symbols of one address have the same place.
struct IoPoint {
  std::uint32_t symbol;
  Table table;
  std::uint16_t number;  ///< protocol address, counted from 0
};

struct IoMap {
  std::vector<IoPoint> points;                 ///< in the order of the symbol list
  std::array<std::uint32_t, kTables> sizes{};  ///< highest number + 1, rounded up to a multiple of 16; 0: empty
  std::array<bool, kTables> packed{};          ///< numbers are positions, not addresses: some address did not fit
  std::vector<std::uint32_t> without_address;  ///< symbols on no link, for want of an address
  std::vector<std::uint32_t> too_wide;         ///< numeric symbols that are not of 16 bits: on no register yet
  std::vector<std::uint32_t> too_many;         ///< symbols beyond the 65,536 places of a table
};

/// The default map of one controller's symbols, which is what a link carries: a symbol's number is its address's own;
/// where one symbol of a table has none or one beyond 65535, that whole table is packed in list order instead.
/// O(symbols).
IoMap make_io_map(const core::PlantTables& tables, std::uint32_t controller);

/// The Modicon number of a place, counted from 1 and written with its table's digit: coil 0 is 1, discrete input 1 is
/// 10002; from 10,000 places on with six digits (110001).
std::uint32_t modicon_number(Table table, std::uint16_t number);

const char* table_name(Table table);

}  // namespace symplant::link

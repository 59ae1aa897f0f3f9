// The requests by which a PLC transfers a map: the channels of its I/O scanner.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "symplant/link/modbus/io_map.hpp"

namespace symplant::map {

/// One cyclic request: a read of events or a write of operations.
struct Channel {
  enum class Part : std::uint8_t { symbols, status_block, watchdog };
  Part part;
  link::modbus::Table table;
  std::uint32_t first;  ///< counted from 0; of bits a multiple of 8
  std::uint32_t count;

  std::uint32_t end() const { return first + count; }
  /// The function code: 2, 15, 4, 16.
  int function() const;
  /// "read discrete inputs".
  std::string_view access() const;
  /// "symbols", "status block", "watchdog".
  std::string_view part_name() const;
};

/// The largest number of bits or registers that one request of a channel can have.
std::uint32_t channel_limit(link::modbus::Table table);

/// The fewest channels that read all events and write all operations of a map, its status block and its watchdog: reads
/// before writes, bits before registers. No number is in two channels, and no channel is longer than a request may be.
/// O(symbols log symbols).
std::vector<Channel> channels_of(const link::modbus::IoMap& map);

}  // namespace symplant::map

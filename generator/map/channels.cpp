// The requests by which a PLC transfers a map.
#include "map/channels.hpp"

#include <algorithm>
#include <array>

#include "symplant/link/modbus/transfer_range.hpp"

namespace symplant::map {
namespace {

using link::modbus::Table;

constexpr std::array kOrder{Table::discrete_input, Table::coil, Table::input_register, Table::holding_register};

void add_symbols(const link::modbus::IoMap& map, Table table, std::vector<Channel>& channels) {
  constexpr std::uint32_t kBitsOfByte = 8;
  bool open = false;
  for (const link::modbus::IoPoint* const point : link::modbus::points_of(map, table)) {
    if (!open || point->last() + 1 > channels.back().first + channel_limit(table)) {
      const std::uint32_t first = has_bits(table) ? point->number / kBitsOfByte * kBitsOfByte : point->number;
      channels.push_back({Channel::Part::symbols, table, first, 0});
      open = true;
    }
    channels.back().count = std::max(channels.back().count, point->last() + 1 - channels.back().first);
  }
}

/// Whether a channel transfers a register already.
bool is_in(const std::vector<Channel>& channels, Table table, std::uint32_t number) {
  return std::any_of(channels.begin(), channels.end(), [&](const Channel& channel) {
    return channel.table == table && channel.first <= number && number < channel.end();
  });
}

}  // namespace

int Channel::function() const {
  constexpr std::array<int, link::modbus::kTables> kFunctions{15, 2, 16, 4};
  return kFunctions[static_cast<std::size_t>(table)];
}

std::string_view Channel::access() const {
  constexpr std::array<std::string_view, link::modbus::kTables> kAccess{
      "write multiple coils", "read discrete inputs", "write multiple registers", "read input registers"};
  return kAccess[static_cast<std::size_t>(table)];
}

std::string_view Channel::part_name() const {
  constexpr std::array<std::string_view, 3> kNames{"symbols", "status block", "watchdog"};
  return kNames[static_cast<std::size_t>(part)];
}

std::uint32_t channel_limit(Table table) {
  constexpr std::array<std::uint32_t, link::modbus::kTables> kLimits{1968, 2000, 123, 125};
  return kLimits[static_cast<std::size_t>(table)];
}

std::vector<Channel> channels_of(const link::modbus::IoMap& map) {
  std::vector<Channel> channels;
  for (const Table table : kOrder) {
    add_symbols(map, table, channels);
    if (table == Table::input_register && map.status_block) {
      channels.push_back({Channel::Part::status_block, table, *map.status_block, link::kStatusWords});
    }
    if (table == Table::holding_register && map.watchdog && !is_in(channels, table, *map.watchdog)) {
      channels.push_back({Channel::Part::watchdog, table, *map.watchdog, 1});
    }
  }
  return channels;
}

}  // namespace symplant::map

// The settings of a Modbus client link: the parameters of its URL.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "symplant/link/client/parts.hpp"
#include "symplant/link/link.hpp"
#include "symplant/link/modbus/io_map.hpp"
#include "symplant/link/net/host_port.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::link::modbus {

/// The areas of a PLC that is a Modbus server.
enum class Area : std::uint8_t { coils, discrete_inputs, holding_registers, input_registers };
inline constexpr std::size_t kAreas = 4;

constexpr bool has_bits(Area area) { return area == Area::coils || area == Area::discrete_inputs; }

/// "holding register".
const char* area_name(Area area);

/// Where a table of the map begins in the PLC: `holding-registers:1024`.
struct Placement {
  Area area = Area::coils;
  std::uint32_t offset = 0;  ///< in coils or registers
};

/// Which bit of a register has the lowest number.
enum class BitOrder : std::uint8_t { low_first, high_first };

/// Which byte of a register comes first on the wire. The protocol has the high one first.
enum class ByteOrder : std::uint8_t { high_first, low_first };

/// A table of the map by its index in Table; nothing for events without a choice.
using Placements = std::array<std::optional<Placement>, kTables>;

struct ClientSettings {
  net::HostPort address;
  std::uint8_t unit = 1;
  /// For a connection, and for one answer; by default less than LinkSettings::loss_after.
  tables::Time timeout = 800 * tables::kMillisecond;
  client::ClientTimes times = {.read_back = tables::kSecond};
  Placements placements = {Placement{Area::coils}, std::nullopt, Placement{Area::holding_registers}, std::nullopt};
  BitOrder bit_order = BitOrder::low_first;
  ByteOrder byte_order = ByteOrder::high_first;
  bool reads_only = false;  ///< events may be inputs of the PLC
};

/// Reads `//HOST:PORT?events=coils&...`, the URL after `modbus-tcp:`. If the link only reads, events are in the PLC's
/// inputs by default. Errors are of kind usage. O(length).
std::variant<ClientSettings, LinkError> read_client_settings(std::string_view rest, bool reads_only = false);

}  // namespace symplant::link::modbus

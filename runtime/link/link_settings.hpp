// The settings of a link in a plant's description, except its URL: numbers of symbols, sizes, policies.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/tables/time.hpp"

namespace symplant::link {

/// The four parts of a link's image. The PLC writes operations and reads events.
enum class Plane : std::uint8_t { operation_bits, event_bits, operation_numbers, event_numbers };
inline constexpr std::size_t kPlanes = 4;

constexpr bool is_event(Plane plane) noexcept { return plane == Plane::event_bits || plane == Plane::event_numbers; }
constexpr bool has_bits(Plane plane) noexcept { return plane == Plane::operation_bits || plane == Plane::event_bits; }

/// Which 16 bits of a longer number come first, in a protocol whose numbers are words of 16 bits.
enum class WordOrder : std::uint8_t {
  low_first,
  high_first,
  as_link,  ///< only for a symbol: the order of its link
};

/// What operations do while their link is lost.
enum class OnLoss : std::uint8_t {
  hold,
  zero,
  as_link,  ///< only for a symbol: the policy of its link
};

/// What the plant does while a link is lost.
enum class PlantOnLoss : std::uint8_t { run, freeze };

/// The settings of one symbol.
struct MapRow {
  static constexpr std::uint32_t kDefault = 0xFFFF'FFFF;

  std::uint32_t symbol = 0;         ///< in PlantTables::symbols
  std::uint32_t number = kDefault;  ///< address in the protocol, counted from 0; kDefault: as in the default map
  WordOrder word_order = WordOrder::as_link;
  OnLoss on_loss = OnLoss::as_link;
  bool excluded = false;       ///< the link does not carry it
  std::string_view node = {};  ///< template of its node id in an OPC UA server; empty: that of the link
};

/// Address of the status or the watchdog: a number, or one of these.
inline constexpr std::uint32_t kAbove = 0xFFFF'FFFE;    ///< the first multiple of 100 above the map
inline constexpr std::uint32_t kNowhere = 0xFFFF'FFFF;  ///< off

/// A counter of the PLC that plant time follows.
struct ClockSettings {
  static constexpr std::uint32_t kNone = 0xFFFF'FFFF;

  std::uint32_t symbol = kNone;               ///< in PlantTables::symbols; kNone: the link has no clock
  tables::Time unit = tables::kMillisecond;   ///< of its lowest bit
  tables::Time limit = 10 * tables::kSecond;  ///< a longer step is a restart
};

/// All settings of a link. The rows must outlive it. A protocol without addresses that count from 0 has no sizes, no
/// status and no watchdog.
struct LinkSettings {
  std::span<const MapRow> rows = {};  ///< symbols whose settings differ from the link's, in ascending order
  WordOrder word_order = WordOrder::high_first;
  bool word_order_given =
      false;  ///< whether the user gave it; else it is that of the symbol list, and a protocol may use another one
  OnLoss on_loss = OnLoss::hold;
  PlantOnLoss plant_on_loss = PlantOnLoss::run;
  std::array<std::uint32_t, kPlanes> sizes = {};   ///< addresses of each plane; 0: as many as the map needs
  tables::Time loss_after = tables::kSecond;       ///< time without a valid request that touches the map
  tables::Time resync = tables::kSecond;           ///< after a loss: longest wait for everything to be written again
  std::uint32_t status_block = kAbove;             ///< first address of the status
  std::uint32_t watchdog = kNowhere;               ///< address of a number that the PLC changes
  tables::Time watchdog_within = tables::kSecond;  ///< longest time without a change of it
  std::uint32_t connections = 32;                  ///< server: clients at once, 1 to 10,000
  tables::Time idle = 300 * tables::kSecond;       ///< server: closes a client without requests for this long; 0: never
  bool arm = false;                                ///< client: write events also to a PLC that cannot be identified
  bool reads_only = false;  ///< client: writes nothing, so that its events may be inputs of the PLC
  ClockSettings clock = {};
  /// Server: numeric addresses of clients that are never closed to make room for others.
  std::span<const std::string_view> keep = {};
};

}  // namespace symplant::link

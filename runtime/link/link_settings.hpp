// The settings of a link in a plant's description, except its URL: numbers of symbols, sizes, policies.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/tables/time.hpp"

namespace symplant::link {

/// The four tables of Modbus. The PLC writes operations and reads events.
enum class Table : std::uint8_t {
  coil,              ///< bit operations
  discrete_input,    ///< bit events
  holding_register,  ///< numeric operations
  input_register,    ///< numeric events
};
inline constexpr std::size_t kTables = 4;

/// Which register of a number with more than 16 bits comes first.
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
  std::uint32_t number = kDefault;  ///< protocol address, counted from 0; kDefault: as in the default map
  WordOrder word_order = WordOrder::as_link;
  OnLoss on_loss = OnLoss::as_link;
  bool excluded = false;  ///< the link does not carry it
};

/// Register of the status block or the watchdog: a number, or one of these.
inline constexpr std::uint32_t kAbove = 0xFFFF'FFFE;    ///< the first multiple of 100 above the map
inline constexpr std::uint32_t kNowhere = 0xFFFF'FFFF;  ///< off

/// A counter of the PLC that plant time follows.
struct ClockSettings {
  static constexpr std::uint32_t kNone = 0xFFFF'FFFF;

  std::uint32_t symbol = kNone;               ///< in PlantTables::symbols; kNone: the link has no clock
  tables::Time unit = tables::kMillisecond;   ///< of its lowest bit
  tables::Time limit = 10 * tables::kSecond;  ///< a longer step is a restart
};

/// All settings of a link. The rows must outlive it.
struct LinkSettings {
  std::span<const MapRow> rows = {};  ///< symbols whose settings differ from the link's, in ascending order
  WordOrder word_order = WordOrder::high_first;
  bool word_order_given =
      false;  ///< by the user; else it is that of the symbol list, and a protocol may have its order
  OnLoss on_loss = OnLoss::hold;
  PlantOnLoss plant_on_loss = PlantOnLoss::run;
  std::array<std::uint32_t, kTables> sizes = {};   ///< addresses of each table; 0: as many as the map needs
  tables::Time loss_after = tables::kSecond;       ///< time without a valid request that touches the map
  tables::Time resync = tables::kSecond;           ///< after a loss: longest wait for everything to be written again
  std::uint32_t status_block = kAbove;             ///< first input register
  std::uint32_t watchdog = kNowhere;               ///< a holding register that the PLC changes
  tables::Time watchdog_within = tables::kSecond;  ///< longest time without a change of it
  std::uint32_t connections = 32;                  ///< server: clients at once, 1 to 10,000
  tables::Time idle = 300 * tables::kSecond;       ///< server: closes a client without requests for this long; 0: never
  bool arm = false;                                ///< client: write events also to a PLC that cannot be identified
  ClockSettings clock = {};
  /// Server: numeric addresses of clients that are never closed to make room for others.
  std::span<const std::string_view> keep = {};
};

}  // namespace symplant::link

// What a plant's description says of a link beside its URL, as data: places of symbols, sizes, policies.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "symplant/tables/time.hpp"

namespace symplant::link {

/// The four tables of Modbus. Operations are what the PLC writes, events what it reads.
enum class Table : std::uint8_t {
  coil,              ///< bit operations
  discrete_input,    ///< bit events
  holding_register,  ///< numeric operations
  input_register,    ///< numeric events
};
inline constexpr std::size_t kTables = 4;

/// Which register of a number of more than 16 bits comes first.
enum class WordOrder : std::uint8_t { low_first, high_first };

/// What operations do while their link is lost.
enum class OnLoss : std::uint8_t {
  hold,
  zero,
  as_link,  ///< of a symbol alone: what its link says
};

/// What the plant does while a link is lost.
enum class PlantOnLoss : std::uint8_t { run, freeze };

/// A symbol with settings of its own.
struct MapRow {
  static constexpr std::uint32_t kDefault = 0xFFFF'FFFF;

  std::uint32_t symbol = 0;         ///< in PlantTables::symbols
  std::uint32_t number = kDefault;  ///< protocol address, counted from 0; kDefault: that of the default map
  WordOrder word_order = WordOrder::low_first;
  OnLoss on_loss = OnLoss::as_link;
};

/// Place of the status block, of the watchdog: a register, or one of these.
inline constexpr std::uint32_t kAbove = 0xFFFF'FFFE;    ///< the first multiple of 100 above the map
inline constexpr std::uint32_t kNowhere = 0xFFFF'FFFF;  ///< there is none

/// Refers to rows that must outlive it.
struct LinkSettings {
  std::span<const MapRow> rows = {};  ///< of symbols whose settings differ from the link's, by symbol
  WordOrder word_order = WordOrder::high_first;
  OnLoss on_loss = OnLoss::hold;
  PlantOnLoss plant_on_loss = PlantOnLoss::run;
  std::array<std::uint32_t, kTables> sizes = {};   ///< places of the tables; 0: as many as the map asks for
  tables::Time loss_after = tables::kSecond;       ///< without a valid request that touches the map
  tables::Time resync = tables::kSecond;           ///< the longest wait, after a loss, for all that was written before
  std::uint32_t status_block = kAbove;             ///< first input register
  std::uint32_t watchdog = kNowhere;               ///< a holding register that the PLC changes
  tables::Time watchdog_within = tables::kSecond;  ///< how long it may stand still
  std::uint32_t connections = 32;                  ///< of a server: clients at once, 1 to 10,000
  tables::Time idle = 300 * tables::kSecond;       ///< of a server: closes a client silent for so long; 0: never
  /// Of a server: numeric addresses of clients that never give way to others.
  std::span<const std::string_view> keep = {};
};

}  // namespace symplant::link

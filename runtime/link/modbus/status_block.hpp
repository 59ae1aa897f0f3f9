// The twelve input registers that tell a PLC programmer how the plant stands (docs/links.md).
#pragma once

#include <array>
#include <cstdint>

#include "symplant/exec/exchange.hpp"
#include "symplant/link/io_map.hpp"

namespace symplant::link::modbus {

inline constexpr std::uint16_t kStatusLayout = 1;  ///< register 0: changes when the layout does

inline constexpr std::uint32_t kStateField = 2;  ///< the register of PlantState, counted from the block's first

enum class PlantState : std::uint16_t { waiting = 0, run = 1, link_lost = 2, frozen = 3, stopping = 4 };

struct StatusBlock {
  PlantState state = PlantState::waiting;
  std::uint64_t cycles = 0;
  std::uint64_t live = 0;  ///< bit i: link i is live
  std::uint64_t lost_exchanges = 0;
  std::uint64_t overruns = 0;
  std::uint64_t map_hash = 0;
};

/// State of the plant as one link tells it: a run that ends comes first, then a plant that stands still, then the
/// link's own state.
PlantState plant_state(exec::LinkState link, bool frozen, bool stopping) noexcept;

/// The registers in their order. Counters are cut to their registers' bits, so that they begin again at 0.
std::array<std::uint16_t, kStatusRegisters> registers_of(const StatusBlock& block, WordOrder order) noexcept;

}  // namespace symplant::link::modbus

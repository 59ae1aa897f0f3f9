// The status block: twelve input registers with the state of the plant (docs/links.md).
#pragma once

#include <array>
#include <cstdint>

#include "symplant/exec/exchange.hpp"
#include "symplant/link/io_map.hpp"

namespace symplant::link::image {

inline constexpr std::uint16_t kStatusLayout = 1;  ///< register 0: changes with the layout

inline constexpr std::uint32_t kStateField = 2;  ///< index of the register of PlantState in the block

enum class PlantState : std::uint16_t { waiting = 0, run = 1, link_lost = 2, frozen = 3, stopping = 4 };

struct StatusBlock {
  PlantState state = PlantState::waiting;
  std::uint64_t cycles = 0;
  std::uint64_t live = 0;  ///< bit i: link i is live
  std::uint64_t lost_exchanges = 0;
  std::uint64_t overruns = 0;
  std::uint64_t map_hash = 0;
};

/// The state of the plant for one link: stopping has priority, then frozen, then the state of the link.
PlantState plant_state(exec::LinkState link, bool frozen, bool stopping) noexcept;

/// The registers in order. Counters are cut to the bits of their registers, so that they wrap around.
std::array<std::uint16_t, kStatusRegisters> registers_of(const StatusBlock& block, WordOrder order) noexcept;

}  // namespace symplant::link::image

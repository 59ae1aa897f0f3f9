// The registers of the status block.
#include "symplant/link/image/status_block.hpp"

#include <span>

namespace symplant::link::image {
namespace {

/// Writes a number that takes several registers.
void put(std::span<std::uint16_t> registers, std::uint64_t value, WordOrder order) noexcept {
  const std::size_t count = registers.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t index = order == WordOrder::low_first ? i : count - 1 - i;
    registers[index] = static_cast<std::uint16_t>(value >> (16 * i));
  }
}

}  // namespace

PlantState plant_state(exec::LinkState link, bool frozen, bool stopping) noexcept {
  if (stopping) return PlantState::stopping;
  if (frozen) return PlantState::frozen;
  if (link == exec::LinkState::waiting) return PlantState::waiting;
  return link == exec::LinkState::lost ? PlantState::link_lost : PlantState::run;
}

std::array<std::uint16_t, kStatusRegisters> registers_of(const StatusBlock& block, WordOrder order) noexcept {
  std::array<std::uint16_t, kStatusRegisters> registers{};
  const std::span<std::uint16_t> all(registers);
  registers[0] = kStatusLayout;
  registers[1] = static_cast<std::uint16_t>(block.cycles);
  registers[kStateField] = static_cast<std::uint16_t>(block.state);
  registers[3] = static_cast<std::uint16_t>(block.live);
  put(all.subspan(4, 2), block.lost_exchanges, order);
  put(all.subspan(6, 2), block.overruns, order);
  put(all.subspan(8, 4), block.map_hash, order);
  return registers;
}

}  // namespace symplant::link::image

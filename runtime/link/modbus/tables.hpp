// The four tables of a Modbus server as plain memory.
#pragma once

#include <cstdint>
#include <span>

#include "symplant/link/image/words.hpp"
#include "symplant/link/modbus/io_map.hpp"

namespace symplant::link::modbus {

/// The words of a table and its number of addresses; there is a bit, or a lane of 16 bits, for every address.
template <class Word>
struct TableView {
  std::span<Word> words;
  std::uint32_t size = 0;
};

/// The input registers: numbers of an image, and the lane there of each register; kNoLane reads 0.
struct InputRegisters {
  std::span<const std::uint64_t> numbers;
  std::span<const std::uint32_t> lanes;

  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(lanes.size()); }
  std::uint16_t operator[](std::uint32_t address) const noexcept {
    return lanes[address] == kNoLane ? std::uint16_t{0} : image::get_lane(numbers, lanes[address]);
  }
};

/// The tables that requests are answered from. A view: it owns nothing.
struct Tables {
  TableView<std::uint64_t> coils;
  TableView<const std::uint64_t> discrete_inputs;
  TableView<std::uint64_t> holding_registers;
  InputRegisters input_registers;
};

}  // namespace symplant::link::modbus

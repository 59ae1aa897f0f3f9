// The 16-bit fields of Modbus frames: high byte first (Modbus Application Protocol V1.1b3, section 4.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace symplant::link::modbus {

inline std::uint16_t field(std::span<const std::uint8_t> bytes, std::size_t offset) noexcept {
  return static_cast<std::uint16_t>(bytes[offset] << 8 | bytes[offset + 1]);
}

inline void put_field(std::span<std::uint8_t> bytes, std::size_t offset, std::uint16_t value) noexcept {
  bytes[offset] = static_cast<std::uint8_t>(value >> 8);
  bytes[offset + 1] = static_cast<std::uint8_t>(value & 0xFF);
}

}  // namespace symplant::link::modbus

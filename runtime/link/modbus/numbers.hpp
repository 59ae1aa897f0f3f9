// Numbers in registers: as the wire has them, and as the plant's slots have them.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "symplant/link/link_settings.hpp"
#include "symplant/link/modbus/places.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::modbus {

/// A number's registers and what they mean. REAL and LREAL are IEEE 754 on the wire; SINT, USINT and BYTE lie in the
/// lower half of one register.
struct NumberPlace {
  std::uint32_t first;
  std::uint32_t registers;  ///< 1, 2 or 4
  WordOrder word_order;
  tables::DataType type;
};

/// By how many bits a register is shifted within the number: the k-th of them.
constexpr std::uint32_t shift_of(const NumberPlace& place, std::uint32_t k) noexcept {
  return 16 * (place.word_order == WordOrder::low_first ? k : place.registers - 1 - k);
}

template <class Signed>
constexpr std::uint64_t extended(std::uint64_t bits) noexcept {
  return static_cast<std::uint64_t>(std::int64_t{static_cast<Signed>(bits)});
}

/// The number as the plant's value slots have it: integers in two's complement of 64 bits, REAL as the bits of a
/// double.
inline std::uint64_t number_at(std::span<const std::uint64_t> registers, const NumberPlace& place) noexcept {
  std::uint64_t bits = 0;
  for (std::uint32_t k = 0; k < place.registers; ++k) {
    bits |= std::uint64_t{get_register(registers, place.first + k)} << shift_of(place, k);
  }
  switch (place.type) {
    case tables::DataType::sint:
      return extended<std::int8_t>(bits);
    case tables::DataType::int_:
      return extended<std::int16_t>(bits);
    case tables::DataType::dint:
      return extended<std::int32_t>(bits);
    case tables::DataType::usint:
    case tables::DataType::byte:
      return bits & 0xFF;
    case tables::DataType::real:
      return std::bit_cast<std::uint64_t>(double{std::bit_cast<float>(static_cast<std::uint32_t>(bits))});
    default:
      return bits;
  }
}

/// Writes a slot's number into its registers. A REAL beyond the range of 32 bits becomes infinite.
inline void set_number(std::span<std::uint64_t> registers, const NumberPlace& place, std::uint64_t value) noexcept {
  if (place.type == tables::DataType::real) {
    value = std::bit_cast<std::uint32_t>(static_cast<float>(std::bit_cast<double>(value)));
  }
  for (std::uint32_t k = 0; k < place.registers; ++k) {
    set_register(registers, place.first + k, static_cast<std::uint16_t>(value >> shift_of(place, k)));
  }
}

}  // namespace symplant::link::modbus

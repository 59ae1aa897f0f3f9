// Converts numbers between Modbus registers and the plant's value slots.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "symplant/link/image/table_view.hpp"
#include "symplant/link/link_settings.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::image {

/// The registers of a number and their meaning. REAL and LREAL are IEEE 754 on the wire; SINT, USINT and BYTE use the
/// lower half of one register.
struct NumberLayout {
  std::uint32_t first;
  std::uint32_t registers;  ///< 1, 2 or 4
  WordOrder word_order;
  tables::DataType type;
};

/// The position in the number, in bits, of its register k.
constexpr std::uint32_t shift_of(const NumberLayout& layout, std::uint32_t k) noexcept {
  return 16 * (layout.word_order == WordOrder::low_first ? k : layout.registers - 1 - k);
}

template <class Signed>
constexpr std::uint64_t extended(std::uint64_t bits) noexcept {
  return static_cast<std::uint64_t>(std::int64_t{static_cast<Signed>(bits)});
}

/// The number as in the plant's value slots: integers in two's complement of 64 bits, REAL as the bits of a double.
inline std::uint64_t number_at(std::span<const std::uint64_t> registers, const NumberLayout& layout) noexcept {
  std::uint64_t bits = 0;
  for (std::uint32_t k = 0; k < layout.registers; ++k) {
    bits |= std::uint64_t{get_register(registers, layout.first + k)} << shift_of(layout, k);
  }
  switch (layout.type) {
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
inline void set_number(std::span<std::uint64_t> registers, const NumberLayout& layout, std::uint64_t value) noexcept {
  if (layout.type == tables::DataType::real) {
    value = std::bit_cast<std::uint32_t>(static_cast<float>(std::bit_cast<double>(value)));
  }
  for (std::uint32_t k = 0; k < layout.registers; ++k) {
    set_register(registers, layout.first + k, static_cast<std::uint16_t>(value >> shift_of(layout, k)));
  }
}

}  // namespace symplant::link::image

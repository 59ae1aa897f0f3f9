// Numbers as a link carries them, and as the plant's value slots have them.
#pragma once

#include <bit>
#include <cstdint>

#include "symplant/link/image/words.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::link::image {

/// Bits of a number on a link: 8 to 64; 0 for BOOL.
constexpr std::uint32_t bits_of(tables::DataType type) noexcept {
  switch (type) {
    case tables::DataType::boolean:
      return 0;
    case tables::DataType::sint:
    case tables::DataType::usint:
    case tables::DataType::byte:
      return 8;
    case tables::DataType::dint:
    case tables::DataType::udint:
    case tables::DataType::dword:
    case tables::DataType::real:
      return 32;
    case tables::DataType::lint:
    case tables::DataType::ulint:
    case tables::DataType::lword:
    case tables::DataType::lreal:
      return 64;
    default:
      return 16;
  }
}

/// Words of 16 bits that a number takes in a protocol that has these: 1, 2 or 4; 1 for BOOL and for 8 bits.
constexpr std::uint8_t words_of(tables::DataType type) noexcept {
  return bits_of(type) <= kLaneBits ? 1 : static_cast<std::uint8_t>(bits_of(type) / kLaneBits);
}

/// The number of an image as in the plant's value slots, which have integers in two's complement of 64 bits and REAL as
/// the bits of a double. Bits above those of the type do not matter.
constexpr std::uint64_t value_of(std::uint64_t number, tables::DataType type) noexcept {
  switch (type) {
    case tables::DataType::sint:
      return static_cast<std::uint64_t>(std::int64_t{static_cast<std::int8_t>(number)});
    case tables::DataType::int_:
      return static_cast<std::uint64_t>(std::int64_t{static_cast<std::int16_t>(number)});
    case tables::DataType::dint:
      return static_cast<std::uint64_t>(std::int64_t{static_cast<std::int32_t>(number)});
    case tables::DataType::real:
      return std::bit_cast<std::uint64_t>(double{std::bit_cast<float>(static_cast<std::uint32_t>(number))});
    default:
      return bits_of(type) == kBitsPerWord ? number : number & ((std::uint64_t{1} << bits_of(type)) - 1);
  }
}

/// A value of the plant as a number of an image: the other direction. Integers keep their sign in the bits above those
/// of their type. A REAL beyond the range of 32 bits becomes infinite.
constexpr std::uint64_t number_of(std::uint64_t value, tables::DataType type) noexcept {
  if (type != tables::DataType::real) return value;
  return std::bit_cast<std::uint32_t>(static_cast<float>(std::bit_cast<double>(value)));
}

}  // namespace symplant::link::image

// Addresses of a program's variables.
#include "symplant/program/address.hpp"

#include <charconv>

#include "symplant/link/image/numbers.hpp"
#include "symplant/tables/ascii.hpp"

namespace symplant::program {
namespace {

/// Reads a number from the begin of the text and removes it from there.
std::optional<std::uint32_t> number_at(std::string_view& text) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

/// Bits by the letter of the size; 0: it is not one.
std::uint8_t size_of(char letter) {
  switch (tables::upper(letter)) {
    case 'X':
      return 1;
    case 'B':
      return 8;
    case 'W':
      return 16;
    case 'D':
      return 32;
    case 'L':
      return 64;
    default:
      return 0;
  }
}

}  // namespace

std::optional<Address> parse_address(std::string_view text) {
  if (text.size() < 3 || text[0] != '%') return std::nullopt;
  const char area = tables::upper(text[1]);
  if (area != 'I' && area != 'Q') return std::nullopt;
  Address address{area == 'I' ? tables::Direction::event : tables::Direction::operation, size_of(text[2]), 0};
  text.remove_prefix(address.bits == 0 ? 2 : 3);
  if (address.bits == 0) address.bits = 1;
  const auto first = number_at(text);
  if (!first) return std::nullopt;
  address.number = *first;
  if (text.empty()) return address;
  if (address.bits != 1 || text[0] != '.' || *first >= (std::uint32_t{1} << 29)) return std::nullopt;
  text.remove_prefix(1);
  const auto bit = number_at(text);
  if (!bit || *bit > 7 || !text.empty()) return std::nullopt;
  address.number = *first * 8 + *bit;
  return address;
}

std::uint8_t bits_of(tables::DataType type) noexcept {
  return type == tables::DataType::boolean ? 1 : static_cast<std::uint8_t>(link::image::bits_of(type));
}

}  // namespace symplant::program

// Makes the values of addresses, for the grammars of the notations.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "address/address.hpp"
#include "text/ascii.hpp"

namespace symplant::address {

/// The highest element number whose bits can be counted with 64 bits.
inline constexpr std::uint64_t kMostElements = UINT64_MAX / 64 - 1;

/// A hash that distinguishes addresses that have no number on a link.
class Key {
 public:
  constexpr Key& add(std::uint64_t part) {
    value_ = (value_ ^ part) * 0x9FB2'1C65'1E98'DF25;
    value_ ^= value_ >> 32U;
    return *this;
  }
  constexpr Key& add(std::string_view text) {
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(text::upper(c))));
    return add(text.size());
  }
  constexpr std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF2'9CE4'8422'2325;
};

/// An address whose bits the notation does not define.
constexpr Address keyed(Area area, Size size, const Key& key) {
  Address address;
  address.area = area;
  address.size = size;
  address.plain = false;
  address.number = key.value();
  return address;
}

/// An address with the number that the text has, and nothing known of its bits.
constexpr Address numbered(Area area, Size size, std::uint64_t number) {
  Address address;
  address.area = area;
  address.size = size;
  address.number = number;
  return address;
}

/// An address that covers `size` bits of a bank from `first_bit` on; `element` gives Address::element.
constexpr Address at_bits(Area area, Size size, Bank bank, Size element, std::uint64_t first_bit) {
  const auto bits = static_cast<std::uint64_t>(size);
  Address address;
  address.area = area;
  address.size = size;
  address.element = static_cast<std::uint8_t>(element);
  address.bank = bank;
  address.first_bit = first_bit;
  const bool is_grouped = size != Size::bit && element == Size::bit;  // K4X0
  const bool is_bit_of_element = bank != kBits && size == Size::bit;  // %IW5.3
  if (area == Area::memory) {
    address.number = Key().add(bank).add(first_bit).value();
  } else if (is_grouped || is_bit_of_element || first_bit % bits != 0) {
    address.plain = false;
    address.number = Key().add(bank).add(first_bit).value();
  } else {
    address.number = first_bit / bits;
  }
  return address;
}

/// The number of a text that consists of digits of a radix. Nothing for other texts, and for texts so long that the
/// number might not fit. A fast path for the addresses that most cells hold; the grammars read all others.
constexpr std::optional<std::uint64_t> usual_number(std::string_view digits, std::uint64_t radix) {
  if (digits.empty() || digits.size() > 15) return std::nullopt;
  std::uint64_t number = 0;
  for (const char c : digits) {
    const char capital = text::upper(c);
    const std::uint64_t digit = text::is_digit(c)                  ? static_cast<std::uint64_t>(c - '0')
                                : capital >= 'A' && capital <= 'F' ? static_cast<std::uint64_t>(capital - 'A') + 10
                                                                   : radix;
    if (digit >= radix) return std::nullopt;
    number = number * radix + digit;
  }
  return number;
}

/// The text without blanks around it.
constexpr std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace symplant::address

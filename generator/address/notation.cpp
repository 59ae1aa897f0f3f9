// The notations of addresses.
#include "address/notation.hpp"

namespace symplant::address {

std::optional<Address> parse(std::string_view text, Notation notation, Radix radix) {
  switch (notation) {
    case Notation::melsec:
      return parse_melsec(text, radix);
    default:
      return parse_iec(text);
  }
}

std::optional<Notation> likely_notation(std::span<const std::string_view> cells) {
  for (const Notation notation : {Notation::iec, Notation::melsec}) {
    std::size_t read = 0;
    for (const std::string_view cell : cells) read += parse(cell, notation, Radix::hexadecimal) ? 1U : 0U;
    if (read * 2 > cells.size()) return notation;
  }
  return std::nullopt;
}

}  // namespace symplant::address

// Which bits an address covers, and the addresses after it.
#pragma once

#include <cstdint>
#include <optional>

#include "address/address.hpp"

namespace symplant::address {

/// The first and the last bit of a bank that an address covers.
struct BitRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};
/// The bits of an address; nothing if the notation does not define them.
std::optional<BitRange> bits_of(const Address& address);

/// Whether two addresses have a bit in common, as far as the notation defines it. Equal addresses do, if they are
/// assigned.
bool overlap(const Address& a, const Address& b);

/// The parts of an address that is written as element and bit: %IX3.5, %IW1410.1, D10.F, 1052.02.
struct ElementBit {
  std::uint64_t element = 0;
  std::uint8_t bit = 0;
};
std::optional<ElementBit> element_and_bit(const Address& address);

/// The address that is `count` elements of the same size after `address`, as in an array. Nothing if the notation does
/// not define it, or if its number exceeds 64 bits.
std::optional<Address> advanced(const Address& address, std::uint64_t count);

}  // namespace symplant::address

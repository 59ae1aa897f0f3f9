// Which bits an address covers, and the addresses after it.
#include "address/bits.hpp"

#include "address/make.hpp"

namespace symplant::address {

std::optional<BitRange> bits_of(const Address& address) {
  if (address.bank == kNoBank) return std::nullopt;
  return BitRange{address.first_bit, address.first_bit + (static_cast<std::uint64_t>(address.size) - 1)};
}

bool overlap(const Address& a, const Address& b) {
  if (same_location(a, b)) return true;
  if (a.area != b.area || a.bank != b.bank) return false;
  const auto bits = bits_of(a);
  const auto others = bits_of(b);
  return bits && others && bits->first <= others->last && others->first <= bits->last;
}

std::optional<ElementBit> element_and_bit(const Address& address) {
  if (address.bank == kNoBank || address.size != Size::bit || address.element == 1) return std::nullopt;
  return ElementBit{address.first_bit / address.element,
                    static_cast<std::uint8_t>(address.first_bit % address.element)};
}

std::optional<Address> advanced(const Address& address, std::uint64_t count) {
  const auto bits = static_cast<std::uint64_t>(address.size);
  const std::uint64_t left = UINT64_MAX - address.first_bit;
  if (address.bank == kNoBank || left < bits - 1 || count > (left - (bits - 1)) / bits) return std::nullopt;
  return at_bits(address.area, address.size, address.bank, static_cast<Size>(address.element),
                 address.first_bit + count * bits);
}

}  // namespace symplant::address

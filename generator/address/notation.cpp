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

}  // namespace symplant::address

// Addresses of I/O, whatever a vendor calls them, as one value.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace symplant::address {

/// Which image of the PLC an address lies in. Everything that is neither its input nor its output is `memory`.
enum class Area : std::uint8_t { input, output, memory };

/// How many bits an address names.
enum class Size : std::uint8_t { bit = 1, byte = 8, word = 16, dword = 32, lword = 64 };

/// In which number system a MELSEC list counts its X and Y.
enum class Radix : std::uint8_t { octal = 8, hexadecimal = 16 };

/// An address as one value; equal addresses compare equal, whatever notation they were written in.
struct Address {
  Area area = Area::memory;
  Size size = Size::bit;
  /// Counted in units of `size`. Of byte.bit notation (%IX3.5) it is 8 * byte + bit. In `memory` and where the address
  /// is not `plain` it only tells one address from another.
  std::uint64_t number = 0;
  /// False where the notation has more parts than a link's number can tell (%IX1.2.3, a bit beyond 7, a word's bit
  /// %IW5.3).
  bool plain = true;

  friend bool operator==(const Address&, const Address&) = default;
};

/// Reads an IEC 61131-3 address: %IX1, %I1, %QX0.5, %IW5, %QD2, %IB3, %MX0.500 (memory). Numbers are decimal. ASCII
/// case does not matter, blanks around are ignored. Nothing where the text is no such address or its number passes 64
/// bits.
std::optional<Address> parse_iec(std::string_view text);

/// Reads a MELSEC device: X1F, Y0001 (inputs and outputs, counted in `radix`), and the names of internal devices with a
/// number (M500, D10, D10.5, B1F, ZR81499, U6\G100: memory). DX and DY are X and Y, accessed directly. Nothing where
/// the text is no such device or has digits beyond `radix`.
std::optional<Address> parse_melsec(std::string_view text, Radix radix);

}  // namespace symplant::address

// Addresses of I/O in any vendor's notation, as one value.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace symplant::address {

/// The image of the PLC that an address is in. All that is neither input nor output is `memory`.
enum class Area : std::uint8_t { input, output, memory };

/// The number of bits that an address names.
enum class Size : std::uint8_t { bit = 1, byte = 8, word = 16, dword = 32, lword = 64 };

/// The number system in which a MELSEC list counts its X and Y.
enum class Radix : std::uint8_t { octal = 8, hexadecimal = 16 };

/// An address as one value; equal addresses in different notations compare equal.
struct Address {
  Area area = Area::memory;
  Size size = Size::bit;
  /// Counted in units of `size`; in byte.bit notation (%IX3.5) 8 * byte + bit. In `memory`, and if the address is not
  /// `plain`, it only distinguishes addresses.
  std::uint64_t number = 0;
  /// False if the notation has more parts than the number of a link can hold (%IX1.2.3, a bit beyond 7, a bit of a word
  /// %IW5.3).
  bool plain = true;

  friend bool operator==(const Address&, const Address&) = default;
};

/// Reads an IEC 61131-3 address: %IX1, %I1, %QX0.5, %IW5, %QD2, %IB3, %MX0.500 (memory). Numbers are decimal. ASCII
/// case and blanks around the text are ignored. Nothing if the text is not such an address or its number exceeds 64
/// bits.
std::optional<Address> parse_iec(std::string_view text);

/// Reads a MELSEC device: X1F, Y0001 (inputs and outputs, counted in `radix`), and the names of internal devices with a
/// number (M500, D10, D10.5, B1F, ZR81499, U6\G100: memory). DX and DY are X and Y, accessed directly. Nothing if
/// the text is not such a device or has digits beyond `radix`.
std::optional<Address> parse_melsec(std::string_view text, Radix radix);

}  // namespace symplant::address

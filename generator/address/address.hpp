// Addresses of I/O in any vendor's notation, as one value.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace symplant::address {

/// The image of the PLC that an address is in. Everything that is neither input nor output is `memory`.
enum class Area : std::uint8_t { input, output, memory };

/// The number of bits that an address names.
enum class Size : std::uint8_t { bit = 1, byte = 8, word = 16, dword = 32, lword = 64 };

/// The number system in which a MELSEC list counts its X and Y.
enum class Radix : std::uint8_t { octal = 8, hexadecimal = 16 };

/// A numbering of bits. Addresses of one area and one bank cover known bits of it.
using Bank = std::uint16_t;
inline constexpr Bank kNoBank = 0;         ///< the notation does not define which bits an address covers
inline constexpr Bank kBits = 1;           ///< of inputs or outputs: X, %IX, bytes and bits of SIMATIC
inline constexpr Bank kMemoryBanks = 256;  ///< from here on: a kind of device of a notation
inline constexpr Bank kHoldingRegisters = kMemoryBanks + 250;  ///< of Modbus reference numbers: 40001
/// The bits of %IB, %IW, %ID or %IL: IEC 61131-3 does not define how elements of different sizes overlap.
constexpr Bank bank_of_elements(Size size) { return static_cast<Bank>(size); }

/// An address as one value; equal addresses in different notations compare equal.
struct Address {
  Area area = Area::memory;
  Size size = Size::bit;
  /// False if the notation has more parts than the number of a link can hold (%IX1.2.3, a bit beyond 7, a bit of a word
  /// %IW5.3).
  bool plain = true;
  bool assigned = true;      ///< false: only the area is known (%I*); each such address is a separate location
  bool sized = true;         ///< false: the text does not give the size, `size` is an assumption (%I*, Local:1:I.Data)
  std::uint8_t element = 1;  ///< bits of the numbered element: 8 for %IX3.5 and %IW64 of SIMATIC, 16 for D10 and D10.F
  Bank bank = kNoBank;
  /// Counted in units of `size`; in byte.bit notation (%IX3.5) 8 * byte + bit. In `memory`, and if the address is not
  /// `plain`, it only distinguishes addresses.
  std::uint64_t number = 0;
  std::uint64_t first_bit = 0;  ///< the first bit of `bank` that the address covers; the others follow

  friend constexpr bool operator==(const Address& a, const Address& b) {
    return a.number == b.number && a.area == b.area && a.size == b.size && a.plain == b.plain &&
           a.assigned == b.assigned;
  }
};

/// The output of the PLC in a holding register: by its reference number (40001) alone it would be memory.
Address as_output_register(const Address& holding);

/// Whether two addresses are one location: they are equal, and assigned.
constexpr bool same_location(const Address& a, const Address& b) { return a.assigned && a == b; }

/// Reads an IEC 61131-3 address: %IX1, %I1, %QX0.5, %IW5, %IW5.12, %QD2, %IX0.0.0, %I*, %MX0.500 (memory), and channels
/// of modules of B&R, %IX."IF3.ST1".DigitalInput01. Numbers are decimal. ASCII case and blanks around the text are
/// ignored. Nothing if the text is not such an address or its number exceeds 64 bits.
std::optional<Address> parse_iec(std::string_view text);

/// Reads a MELSEC device: X1F, Y0001 (inputs and outputs, counted in `radix`), K4X0 (16 inputs from X0 on), and
/// internal devices with a number (M500, D10, D10.5, B1F, ZR81499, U6\G100, J1\X10: memory). DX and DY are X and Y,
/// accessed directly. Nothing if the text is not such a device or has digits beyond `radix`.
std::optional<Address> parse_melsec(std::string_view text, Radix radix);

}  // namespace symplant::address

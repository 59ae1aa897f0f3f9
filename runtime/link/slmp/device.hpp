// MELSEC devices: their codes on the wire, and their texts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace symplant::link::slmp {

/// The PLC series, which decides how X and Y are counted and what a request may hold.
enum class Family : std::uint8_t { q, l, iqr, fx5 };

/// What MELSEC calls a device: X, M, D. An index in the table of device kinds.
using Kind = std::uint8_t;

struct KindInfo {
  std::string_view name;
  std::uint8_t code;
  bool bit;           ///< a bit for each number; otherwise a word of 16 bits
  std::uint8_t base;  ///< of the number in texts; 0: hexadecimal, on FX5 octal
  bool fx5;           ///< an FX5 has it
  bool batch_only;    ///< not allowed in random and block access (end code 4032)
};

const KindInfo& info_of(Kind kind) noexcept;
/// The kind with this name, in upper case; nothing if there is none.
std::optional<Kind> kind_of(std::string_view name) noexcept;
/// The kind with this code on the wire; nothing if there is none.
std::optional<Kind> kind_with_code(std::uint8_t code) noexcept;
/// The base of the numbers of a kind in texts: 8, 10 or 16.
std::uint32_t base_of(Kind kind, Family family) noexcept;

/// Numbers on the wire have 24 bits with the commands of Q and L.
inline constexpr std::uint32_t kMostDevices = std::uint32_t{1} << 24;

/// A device, or a bit of a word device.
struct Device {
  static constexpr std::uint8_t kNoBit = 0xFF;

  Kind kind = 0;
  std::uint32_t number = 0;
  std::uint8_t bit = kNoBit;  ///< of a word device: 0 to 15
  std::uint8_t digits = 0;    ///< K4X0: 4 groups of 4 bits from X0 on; 0: none given

  bool is_bit() const noexcept { return digits == 0 && (info_of(kind).bit || bit != kNoBit); }
  friend bool operator==(const Device&, const Device&) = default;
};

/// Reads `X1F`, `x0010`, `D100`, `D100.F`, `ZR5`, `K4X0`, or the IEC form of GX IEC Developer: `%IX16`, `%Q31`,
/// `%MX0.100` (M100), `%MW1.5` (W5). The numbers of X and Y are in the base of the family. Nothing if the text is not a
/// device that can be read and written by SLMP. O(length).
std::optional<Device> parse_device(std::string_view text, Family family);

/// `X1F`, `D100.F`.
std::string device_text(const Device& device, Family family);

}  // namespace symplant::link::slmp

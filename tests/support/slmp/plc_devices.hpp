// The devices of a PLC: names, codes on the wire, number bases, default sizes (section 1.5 of the SLMP reference).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace symplant::test::slmp {

enum class Family : std::uint8_t { q, l, iqr, fx5 };
inline constexpr std::array kFamilies = {Family::q, Family::l, Family::iqr, Family::fx5};

/// The code of the data on the wire.
enum class Code : std::uint8_t { binary, ascii };

enum class NumberBase : std::uint8_t {
  decimal,
  hex,
  input_output,  ///< hex, on FX5 octal
};

struct DeviceType {
  std::string_view name;     ///< in users' text and in ASCII with iQ-R subcommands
  std::string_view ql_name;  ///< in ASCII with Q/L subcommands
  std::uint16_t code;
  bool is_bit;
  NumberBase base;
  std::array<std::uint32_t, 4> points;  ///< by family; 0: the family does not have the device
  std::string_view shares;              ///< the device in whose memory this one is, if a CPU has both
};

std::span<const DeviceType> device_types();
/// Null if unknown.
const DeviceType* device_of_name(std::string_view name);
const DeviceType* device_of_code(std::uint16_t code);
/// `name` with its padding of `*`, 2 characters (Q/L) or 4 (iQ-R).
const DeviceType* device_of_padded_name(std::string_view name);
/// Position in device_types().
std::size_t index_of(const DeviceType& device);

/// `X1F`, on FX5 `X37`.
std::string address_text(const DeviceType& device, std::uint32_t number, Family family = Family::iqr);
/// 8, 10 or 16.
unsigned base_of(const DeviceType& device, Family family);

}  // namespace symplant::test::slmp

// The notations of addresses: whose grammar an address is written in.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "address/address.hpp"

namespace symplant::address {

enum class Notation : std::uint8_t {
  iec,       ///< IEC 61131-3: %IX0.5, %QW3
  melsec,    ///< Mitsubishi: X1F, Y10, M500, D10.5
  siemens,   ///< SIMATIC, English and German mnemonics: %I0.0, E 2.6, PIW 64, %IW64:P
  rockwell,  ///< a resolved tag of a module: Local:1:I.Data.0
  omron,     ///< CX-Programmer: 1052.02, W10.00, D20042
  modbus,    ///< reference numbers: 10001, 400001
};

/// Reads an address of a notation. `radix` is that of X and Y. Nothing if the text is not such an address.
std::optional<Address> parse(std::string_view text, Notation notation, Radix radix);

/// The notation that reads most of the cells; nothing if it reads less than half of them.
std::optional<Notation> likely_notation(std::span<const std::string_view> cells);

}  // namespace symplant::address

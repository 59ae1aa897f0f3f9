// The notations of addresses: whose grammar an address is written in.
#pragma once

#include <cstdint>
#include <vector>

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

/// Which words of a shared area are inputs or outputs, where addresses do not show it. The first range that holds a
/// word decides.
struct IoRanges {
  struct Range {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
    Area area = Area::memory;
  };
  std::vector<Range> ranges;
};

/// How the addresses of a list are read.
struct Dialect {
  Notation notation = Notation::iec;
  Radix radix = Radix::hexadecimal;  ///< how X and Y are counted
  const IoRanges* ranges = nullptr;  ///< the inputs and outputs in CIO; null: all of CIO is memory
};

}  // namespace symplant::address

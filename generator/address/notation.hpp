// The notations of addresses: whose grammar an address is written in.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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

/// Which words of a shared area are inputs or outputs, where addresses do not show it. The first range with a word
/// counts.
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
  Radix radix = Radix::hexadecimal;  ///< of X and Y
  const IoRanges* ranges = nullptr;  ///< of CIO; null: all of it is memory
};

/// Reads an address. Nothing if the text is not one of the notation. Neither allocates nor throws.
std::optional<Address> parse(std::string_view text, const Dialect& dialect);

/// Writes an address of the notation; a text that `parse` reads as an equal one. Nothing if the notation has no such
/// address, or the value does not hold its text (Local:1:I.Data, %IX1.2.3).
std::optional<std::string> to_text(const Address& address, const Dialect& dialect);

/// The notation that reads most of the cells, at least half of those that are not empty. Nothing if none does, or if
/// two read equally many and disagree about the area of a cell. SIMATIC's `%I0.0` is valid in IEC 61131-3 as well: it
/// is SIMATIC's unless the cells have other forms of IEC 61131-3.
std::optional<Notation> likely_notation(std::span<const std::string_view> cells);

/// How certainly a text is an address, and not a name: 0 no, 1 perhaps (M1, D10, 40001), 2 yes (X1F, %IX0.5, I 0.0).
int address_strength(std::string_view text);
inline bool looks_like_address(std::string_view text) { return address_strength(text) == 2; }

/// The notation that reads most of the cells; nothing if it reads less than half of them.
std::optional<Notation> likely_notation(std::span<const std::string_view> cells);

}  // namespace symplant::address

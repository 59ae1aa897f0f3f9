// Addresses of a program's variables.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "symplant/tables/tables.hpp"

namespace symplant::program {

/// "%IX3.2" of IEC 61131-3: a bit, byte or word of inputs or outputs, with the number that a symbol's address has.
struct Address {
  tables::Direction direction;  ///< outputs are operations
  std::uint8_t bits;            ///< 1, 8, 16, 32 or 64
  std::uint32_t number;         ///< %IX3.2 and %IX26: 26; %IW5: 5
};

/// Nothing if the text is not such an address. ASCII case is ignored; `%I5` is `%IX5`.
std::optional<Address> parse_address(std::string_view text);

/// The width in bits of a symbol of this type; 1 for BOOL.
std::uint8_t bits_of(tables::DataType type) noexcept;

}  // namespace symplant::program

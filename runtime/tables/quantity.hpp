// Parses numbers with a unit, such as "500ms" and "1.5 m".
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace symplant::tables {

struct Unit {
  std::string_view name;
  std::int64_t size;  ///< in the smallest unit, > 0
};

/// A number, optional blanks, and one of the units; decimal fractions are exact. Empty if the text does not have this
/// form, is negative, has a part below the smallest unit, or is not below 2^63 - 1.
std::optional<std::int64_t> parse_quantity(std::string_view text, std::span<const Unit> units) noexcept;

}  // namespace symplant::tables

// Parses lengths such as "300 mm", speeds such as "0.4 m/s", and locations such as "CV1@300 mm".
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace symplant::tables {

/// In um: a number and one of um mm cm m. Empty if the text is not a length, is negative, or has a part below 1 um.
std::optional<std::int64_t> parse_length(std::string_view text) noexcept;

/// In um/s: a number and one of um/s mm/s m/s m/min, the last one rounded down. Empty if the text is not a speed, is
/// negative, or has a part below 1 um/s (1 um/min).
std::optional<std::int64_t> parse_speed(std::string_view text) noexcept;

/// A location as text: TRACK@POSITION, or only a name. Views point into the text; blanks around the parts are left out.
struct LocationText {
  std::string_view name;
  std::string_view position;  ///< of a name without `@`: empty
  bool has_position = false;
};
LocationText split_location(std::string_view text) noexcept;

}  // namespace symplant::tables

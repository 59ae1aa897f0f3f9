// Parses durations such as "500ms", "1.5 s" and "2h", and writes them in seconds.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "symplant/tables/time.hpp"

namespace symplant::tables {

/// A number, optional blanks, and one of ns us ms s min h; decimal fractions are exact. Empty if the text is not a
/// duration, is negative, has a part below 1 ns, or is not below the 292 years that 64 bits hold.
std::optional<Time> parse_duration(std::string_view text) noexcept;

/// A time that is not negative in seconds, exact: "1.5s", "21s". parse_duration() reads it back, and so does CSS.
std::string duration_text(Time time);

}  // namespace symplant::tables

// Shared by readers of delimited lists that are known by their header.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "read/cells/table_reading.hpp"

namespace symplant::read {

/// Likelihood of a list whose header is known.
inline constexpr int kKnownHeader = 95;

/// Words that a header has, as header_word() makes them; empty words do not count.
using HeaderWords = std::array<std::string_view, 4>;

/// The layout below the first header that has all words of one of several languages.
std::optional<Layout> layout_in_any(std::string_view text, std::span<const HeaderWords> languages);

}  // namespace symplant::read

// The words for truth values.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "text/ascii.hpp"

namespace symplant::text {

/// Whether a word is TRUE or FALSE, as tools in German, French, Italian, Spanish and Portuguese write it, too. Ignores
/// ASCII case. Nothing for other words.
inline std::optional<bool> truth_of(std::string_view word) {
  constexpr std::array<std::string_view, 5> kTrue{"TRUE", "WAHR", "VRAI", "VERO", "VERDADERO"};
  constexpr std::array<std::string_view, 4> kFalse{"FALSE", "FALSCH", "FAUX", "FALSO"};
  const auto is_it = [&](std::string_view other) { return equal_ignoring_case(word, other); };
  if (std::any_of(kTrue.begin(), kTrue.end(), is_it)) return true;
  if (std::any_of(kFalse.begin(), kFalse.end(), is_it)) return false;
  return std::nullopt;
}

}  // namespace symplant::text

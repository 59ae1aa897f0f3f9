// What the bit of a symbol means, in words.
#pragma once

#include <string_view>

namespace symplant::tables {

/// `on` or `off`; of an inverted symbol followed by its bit, which is the opposite: `on (bit 0)`, `off (bit 1)`.
constexpr std::string_view level_text(bool on, bool inverted) noexcept {
  if (!inverted) return on ? "on" : "off";
  return on ? "on (bit 0)" : "off (bit 1)";
}

}  // namespace symplant::tables

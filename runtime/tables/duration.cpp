// Parses durations such as "500ms".
#include "symplant/tables/duration.hpp"

#include <array>

#include "symplant/tables/quantity.hpp"

namespace symplant::tables {

std::optional<Time> parse_duration(std::string_view text) noexcept {
  static constexpr std::array<Unit, 6> kUnits{{{"ns", 1},
                                               {"us", kMicrosecond},
                                               {"ms", kMillisecond},
                                               {"s", kSecond},
                                               {"min", 60 * kSecond},
                                               {"h", 3600 * kSecond}}};
  return parse_quantity(text, kUnits);
}

}  // namespace symplant::tables

// Parses and writes durations such as "500ms".
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

std::string duration_text(Time time) {
  std::string text = std::to_string(time / kSecond);
  if (const Time rest = time % kSecond; rest != 0) {
    text.append(".").append(std::to_string(kSecond + rest), 1, 9);  // with its leading zeros
    text.erase(text.find_last_not_of('0') + 1);
  }
  return text + "s";
}

}  // namespace symplant::tables

// Texts of numbers on a link.
#include "app/map/texts.hpp"

#include <fmt/format.h>

namespace symplant::app {

std::string range_text(std::uint32_t first, std::uint32_t count) {
  return count == 1 ? std::to_string(first) : fmt::format("{}-{}", first, first + count - 1);
}

std::string address_text(const link::IoPoint& point) {
  return fmt::format("{}{} {}", link::table_name(point.table), point.width == 1 ? "" : "s",
                     range_text(point.number, point.width));
}

std::string modicon_text(const link::IoPoint& point) {
  const auto one = [&](std::uint32_t number) {
    constexpr std::uint32_t kLastOfFiveDigits = 9998;  // coil 010000 and discrete input 10000 differ by the 0
    return fmt::format("{:0{}}", link::modicon_number(point.table, number), number > kLastOfFiveDigits ? 6 : 5);
  };
  if (point.width == 1) return one(point.number);
  return one(point.number) + "-" + one(point.last());
}

std::string word_order_text(link::WordOrder order) {
  return order == link::WordOrder::low_first ? "low word first" : "high word first";
}

}  // namespace symplant::app

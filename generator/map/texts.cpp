// Texts of numbers on a link.
#include "map/texts.hpp"

#include <fmt/format.h>

namespace symplant::map {

std::string range_text(std::uint32_t first, std::uint32_t count) {
  return count == 1 ? std::to_string(first) : fmt::format("{}-{}", first, first + count - 1);
}

std::string modicon_text(const link::modbus::IoPoint& point) {
  const auto one = [&](std::uint32_t number) {
    constexpr std::uint32_t kLastOfFiveDigits = 9998;  // coil 010000 and discrete input 10000 differ by the 0
    return fmt::format("{:0{}}", link::modbus::modicon_number(point.table, number), number > kLastOfFiveDigits ? 6 : 5);
  };
  if (point.width == 1) return one(point.number);
  return one(point.number) + "-" + one(point.last());
}

std::string word_order_text(link::WordOrder order) {
  return order == link::WordOrder::low_first ? "low word first" : "high word first";
}

}  // namespace symplant::map

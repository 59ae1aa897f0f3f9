// Parses lengths, speeds and locations.
#include "symplant/tables/length.hpp"

#include <array>

#include "symplant/tables/quantity.hpp"

namespace symplant::tables {
namespace {

constexpr std::int64_t kMillimeter = 1'000;
constexpr std::int64_t kMeter = 1'000'000;
constexpr std::int64_t kSecondsInMinute = 60;

std::string_view trimmed(std::string_view text) noexcept {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

}  // namespace

std::optional<std::int64_t> parse_length(std::string_view text) noexcept {
  static constexpr std::array<Unit, 4> kUnits{
      {{"um", 1}, {"mm", kMillimeter}, {"cm", 10 * kMillimeter}, {"m", kMeter}}};
  return parse_quantity(text, kUnits);
}

std::optional<std::int64_t> parse_speed(std::string_view text) noexcept {
  static constexpr std::array<Unit, 3> kPerSecond{{{"um/s", 1}, {"mm/s", kMillimeter}, {"m/s", kMeter}}};
  static constexpr std::array<Unit, 1> kPerMinute{{{"m/min", kMeter}}};
  if (const auto speed = parse_quantity(text, kPerSecond)) return speed;
  const auto speed = parse_quantity(text, kPerMinute);
  return speed ? std::optional(*speed / kSecondsInMinute) : std::nullopt;
}

LocationText split_location(std::string_view text) noexcept {
  const std::size_t at = text.rfind('@');
  if (at == text.npos) return {trimmed(text), {}, false};
  return {trimmed(text.substr(0, at)), trimmed(text.substr(at + 1)), true};
}

}  // namespace symplant::tables

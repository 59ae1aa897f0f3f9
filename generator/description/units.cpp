// Lengths and speeds of a plant description.
#include "description/units.hpp"

#include <string_view>

#include "symplant/tables/length.hpp"
#include "symplant/tables/material.hpp"

namespace symplant::description {
namespace {

/// A kind of quantity, in the words of messages.
struct Quantity {
  std::optional<std::int64_t> (*parse)(std::string_view) noexcept;
  std::int64_t most;
  std::string_view too_large;  ///< after the text
  std::string_view too_fine;
  std::string_view other;
};

constexpr Quantity kLength{tables::parse_length, tables::kMaxLength,
                           " is longer than the maximum of 1 km; write a shorter length",
                           " has a part below 1 um; give it fewer decimals",
                           " is not a length; write a number and um, mm, cm or m, such as `300 mm`"};
constexpr Quantity kSpeed{tables::parse_speed, tables::kMaxSpeed,
                          " is faster than the maximum of 100 m/s; write a lower speed",
                          " has a part below 1 um/s (1 um/min); give it fewer decimals",
                          " is not a speed; write a number and mm/s, m/s or m/min, such as `0.4 m/s`"};

std::string_view why_none(std::string_view text, const Quantity& quantity) {
  constexpr std::string_view kDigits = "0123456789";
  const std::size_t end = text.find_first_not_of(kDigits);
  if (end == text.npos || end == 0) return quantity.other;
  std::size_t unit = end;
  if (text[end] == '.') {
    unit = text.find_first_not_of(kDigits, end + 1);
    if (unit == text.npos || unit == end + 1) return quantity.other;
  }
  const std::string_view rest = text.substr(unit);
  if (!quantity.parse("1" + std::string(rest))) return quantity.other;
  // The unit is known, so the number is at fault: its fraction, unless it is too large without it.
  return quantity.parse(std::string(text.substr(0, end)).append(rest)) ? quantity.too_fine : quantity.too_large;
}

std::optional<std::int64_t> quantity_of(const std::string& text, const Quantity& quantity, const Pointer& here,
                                        ShapeFaults& faults) {
  const auto value = quantity.parse(text);
  if (value && *value <= quantity.most) return value;
  faults.add(here, ticked(text) + std::string(value ? quantity.too_large : why_none(text, quantity)));
  return std::nullopt;
}

}  // namespace

std::optional<std::int64_t> length_of(const std::string& text, const Pointer& here, ShapeFaults& faults) {
  return quantity_of(text, kLength, here, faults);
}

std::optional<std::int64_t> length_above_zero(const std::string& text, const Pointer& here, ShapeFaults& faults) {
  const auto length = length_of(text, here, faults);
  if (length != 0) return length;
  faults.add(here, ticked(text) + " is no length above 0; write a longer length");
  return std::nullopt;
}

std::optional<std::int64_t> speed_of(const std::string& text, const Pointer& here, ShapeFaults& faults) {
  const auto speed = quantity_of(text, kSpeed, here, faults);
  if (speed != 0) return speed;
  faults.add(here, ticked(text) + " is below 1 um/s; write a higher speed");
  return std::nullopt;
}

}  // namespace symplant::description

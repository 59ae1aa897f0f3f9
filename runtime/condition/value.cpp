// Reads the value of a numeric symbol.
#include "symplant/condition/value.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "symplant/condition/compare.hpp"
#include "symplant/condition/number.hpp"
#include "symplant/condition/type_info.hpp"

namespace symplant::condition {
namespace {

using tables::DataType;

std::string type_text(DataType type) { return std::string(type_name(type)); }

bool is_signed(DataType type) { return info_of(type).kind == tables::NumberKind::signed_integer; }

/// The range of an integer type, such as "-128 to 127".
std::string range_text(DataType type) {
  const int bits = info_of(type).bits;
  if (is_signed(type)) {
    const std::int64_t most = std::numeric_limits<std::int64_t>::max() >> (64 - bits);
    return std::to_string(-most - 1) + " to " + std::to_string(most);
  }
  return "0 to " + std::to_string(~std::uint64_t{0} >> (64 - bits));
}

std::variant<std::uint64_t, std::string> read_integer(DataType type, std::string_view text, const std::string& shown) {
  const auto number = Number::read(text);
  if (!number) return shown + " is not a number, " + type_text(type) + " is " + range_text(type);
  if (!number->is_whole()) return shown + " is not a whole number, " + type_text(type) + " is " + range_text(type);
  const WholeNumber whole = number->floor();
  const int bits = info_of(type).bits;
  const bool negative = is_signed(type);
  const std::uint64_t most = ~std::uint64_t{0} >> (64 - bits + (negative ? 1 : 0));
  const std::uint64_t limit = !whole.negative ? most : negative ? most + 1 : 0;
  if (whole.huge || whole.magnitude > limit) {
    return shown + " is out of range for " + type_text(type) + ", " + range_text(type);
  }
  return whole.negative ? ~whole.magnitude + 1 : whole.magnitude;
}

std::variant<std::uint64_t, std::string> read_real(DataType type, std::string_view text, const std::string& shown) {
  double real = 0;
  if (text == "nan") {
    real = std::numeric_limits<double>::quiet_NaN();
  } else if (text == "inf" || text == "-inf") {
    real = text == "inf" ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
  } else {
    const auto number = Number::read(text);
    if (!number) return shown + " is not a number; write a number, or `nan`, `inf`, `-inf`";
    const auto nearest = number->real();
    const bool too_large = nearest && type == DataType::real && std::isinf(static_cast<float>(*nearest));
    if (!nearest || too_large) return shown + " is out of range for " + type_text(type);
    real = *nearest;
    if (real == 0 && text.starts_with('-')) real = -0.0;
  }
  return std::bit_cast<std::uint64_t>(type == DataType::real ? double{static_cast<float>(real)} : real);
}

}  // namespace

std::variant<std::uint64_t, std::string> read_number(DataType type, std::string_view text, const std::string& shown) {
  return info_of(type).kind == tables::NumberKind::real ? read_real(type, text, shown)
                                                        : read_integer(type, text, shown);
}

}  // namespace symplant::condition

// Values of symbols as a scenario writes them.
#include "symplant/scenario/value.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "symplant/condition/compare.hpp"
#include "symplant/condition/number.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::scenario {
namespace {

using tables::DataType;

std::string type_text(DataType type) { return std::string(condition::type_name(type)); }

/// The smallest and the largest value of an integer type, as people read them.
std::string range_text(DataType type) {
  const int bits = trace::width(type);
  if (trace::is_signed(type)) {
    const std::int64_t most = std::numeric_limits<std::int64_t>::max() >> (64 - bits);
    return std::to_string(-most - 1) + " to " + std::to_string(most);
  }
  return "0 to " + std::to_string(~std::uint64_t{0} >> (64 - bits));
}

/// A number as its author wrote it; nothing where it is none.
std::optional<condition::Number> number_of(const nlohmann::json& value) {
  if (value.is_string()) return condition::Number::read(value.get_ref<const std::string&>());
  return condition::Number::read(value.dump());
}

/// Of a zero: a trace writes `-0`, and that reads back.
bool is_negative(const nlohmann::json& value) {
  return value.is_string() ? value.get_ref<const std::string&>().starts_with('-')
                           : value.is_number_float() && std::signbit(value.get<double>());
}

std::string shown(const nlohmann::json& value) { return "`" + value.dump() + "`"; }

std::variant<std::uint64_t, std::string> read_integer(DataType type, const nlohmann::json& value) {
  const auto number = number_of(value);
  if (!number) return shown(value) + " is no number, " + type_text(type) + " is " + range_text(type);
  if (!number->is_whole()) return shown(value) + " is no whole number, " + type_text(type) + " is " + range_text(type);
  const condition::WholeNumber whole = number->floor();
  const int bits = trace::width(type);
  const bool is_signed = trace::is_signed(type);
  const std::uint64_t most = ~std::uint64_t{0} >> (64 - bits + (is_signed ? 1 : 0));
  const std::uint64_t limit = !whole.negative ? most : is_signed ? most + 1 : 0;
  if (whole.huge || whole.magnitude > limit) {
    return shown(value) + " is beyond what " + type_text(type) + " holds, " + range_text(type);
  }
  return whole.negative ? ~whole.magnitude + 1 : whole.magnitude;
}

std::variant<std::uint64_t, std::string> read_real(DataType type, const nlohmann::json& value) {
  double real = 0;
  if (value == "nan") {
    real = std::numeric_limits<double>::quiet_NaN();
  } else if (value == "inf" || value == "-inf") {
    real = value == "inf" ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
  } else {
    const auto number = number_of(value);
    if (!number) return shown(value) + " is no number, " + type_text(type) + " is one, or `nan`, `inf`, `-inf`";
    const auto nearest = number->real();
    const bool too_large = nearest && type == DataType::real && std::isinf(static_cast<float>(*nearest));
    if (!nearest || too_large) return shown(value) + " is beyond what " + type_text(type) + " holds";
    real = *nearest;
    if (real == 0 && is_negative(value)) real = -0.0;
  }
  return std::bit_cast<std::uint64_t>(type == DataType::real ? double{static_cast<float>(real)} : real);
}

}  // namespace

std::variant<std::uint64_t, std::string> read_value(DataType type, const nlohmann::json& value) {
  if (type == DataType::boolean) {
    if (value.is_boolean()) return value.get<bool>() ? 1U : 0U;
    return shown(value) + " stands here, a BOOL is true or false";
  }
  if (value.is_boolean()) return shown(value) + " stands here, " + type_text(type) + " is a number";
  return trace::is_real(type) ? read_real(type, value) : read_integer(type, value);
}

}  // namespace symplant::scenario

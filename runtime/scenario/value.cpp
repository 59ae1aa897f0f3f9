// Reads the values of symbols in a scenario.
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

/// The range of an integer type, such as "-128 to 127".
std::string range_text(DataType type) {
  const int bits = trace::width(type);
  if (trace::is_signed(type)) {
    const std::int64_t most = std::numeric_limits<std::int64_t>::max() >> (64 - bits);
    return std::to_string(-most - 1) + " to " + std::to_string(most);
  }
  return "0 to " + std::to_string(~std::uint64_t{0} >> (64 - bits));
}

/// The exact number of a JSON number or text; empty if it is not a number.
std::optional<condition::Number> number_of(const nlohmann::json& value) {
  if (value.is_string()) return condition::Number::read(value.get_ref<const std::string&>());
  return condition::Number::read(value.dump());
}

/// Whether a zero is negative: traces write `-0`, which must be read back.
bool is_negative(const nlohmann::json& value) {
  return value.is_string() ? value.get_ref<const std::string&>().starts_with('-')
                           : value.is_number_float() && std::signbit(value.get<double>());
}

std::string shown(const nlohmann::json& value) { return "`" + value.dump() + "`"; }

std::variant<std::uint64_t, std::string> read_integer(DataType type, const nlohmann::json& value) {
  const auto number = number_of(value);
  if (!number) return shown(value) + " is not a number, " + type_text(type) + " is " + range_text(type);
  if (!number->is_whole())
    return shown(value) + " is not a whole number, " + type_text(type) + " is " + range_text(type);
  const condition::WholeNumber whole = number->floor();
  const int bits = trace::width(type);
  const bool is_signed = trace::is_signed(type);
  const std::uint64_t most = ~std::uint64_t{0} >> (64 - bits + (is_signed ? 1 : 0));
  const std::uint64_t limit = !whole.negative ? most : is_signed ? most + 1 : 0;
  if (whole.huge || whole.magnitude > limit) {
    return shown(value) + " is out of range for " + type_text(type) + ", " + range_text(type);
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
    if (!number) return shown(value) + " is not a number; write a number, or `nan`, `inf`, `-inf`";
    const auto nearest = number->real();
    const bool too_large = nearest && type == DataType::real && std::isinf(static_cast<float>(*nearest));
    if (!nearest || too_large) return shown(value) + " is out of range for " + type_text(type);
    real = *nearest;
    if (real == 0 && is_negative(value)) real = -0.0;
  }
  return std::bit_cast<std::uint64_t>(type == DataType::real ? double{static_cast<float>(real)} : real);
}

}  // namespace

std::variant<std::uint64_t, std::string> read_value(DataType type, const nlohmann::json& value) {
  if (type == DataType::boolean) {
    if (value.is_boolean()) return value.get<bool>() ? 1U : 0U;
    return "expected true or false for a BOOL, but found " + shown(value);
  }
  if (value.is_boolean()) return "expected a number for " + type_text(type) + ", but found " + shown(value);
  return trace::is_real(type) ? read_real(type, value) : read_integer(type, value);
}

}  // namespace symplant::scenario

// Texts of values and names.
#include "symplant/trace/value_text.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "symplant/tables/level.hpp"

namespace symplant::trace {
namespace {

using tables::DataType;

constexpr std::uint64_t kExactInDouble = std::uint64_t{1} << 53;

std::string real_text(DataType type, double number) {
  return type == DataType::real ? fmt::format("{}", static_cast<float>(number)) : fmt::format("{}", number);
}

std::string integer_text(DataType type, std::uint64_t value) {
  return is_signed(type) ? std::to_string(static_cast<std::int64_t>(value)) : std::to_string(value);
}

}  // namespace

std::string json_string(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

bool is_signed(DataType type) noexcept {
  return type == DataType::sint || type == DataType::int_ || type == DataType::dint || type == DataType::lint;
}

bool is_real(DataType type) noexcept { return type == DataType::real || type == DataType::lreal; }

int width(DataType type) noexcept {
  switch (type) {
    case DataType::boolean:
      return 1;
    case DataType::sint:
    case DataType::usint:
    case DataType::byte:
      return 8;
    case DataType::int_:
    case DataType::uint:
    case DataType::word:
      return 16;
    case DataType::dint:
    case DataType::udint:
    case DataType::dword:
    case DataType::real:
      return 32;
    case DataType::lint:
    case DataType::ulint:
    case DataType::lword:
    case DataType::lreal:
      break;
  }
  return 64;
}

std::string json_value(DataType type, std::uint64_t value) {
  if (type == DataType::boolean) return value != 0 ? "true" : "false";
  if (is_real(type)) {
    const double number = std::bit_cast<double>(value);
    if (std::isnan(number)) return "\"nan\"";  // also with a sign
    const std::string text = real_text(type, number);
    return std::isfinite(number) ? text : '"' + text + '"';
  }
  const bool negative = is_signed(type) && static_cast<std::int64_t>(value) < 0;
  const std::uint64_t magnitude = negative ? ~value + 1 : value;
  const std::string text = integer_text(type, value);
  return magnitude > kExactInDouble ? '"' + text + '"' : text;
}

std::string value_text(const tables::SymbolRow& symbol, std::uint64_t value) {
  const DataType type = symbol.type();
  if (type == DataType::boolean) {
    return std::string(tables::level_text((value != 0) != symbol.inverted(), symbol.inverted()));
  }
  return is_real(type) ? real_text(type, std::bit_cast<double>(value)) : integer_text(type, value);
}

}  // namespace symplant::trace

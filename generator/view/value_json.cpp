// The value of a symbol as JSON.
#include "view/value_json.hpp"

#include <bit>
#include <cmath>
#include <string>

#include "view/words.hpp"

namespace symplant::view {

void write_value(tables::DataType type, std::uint64_t value, JsonWriter& json) {
  using tables::DataType;
  if (type == DataType::boolean) return json.value(value != 0);
  const std::string text = value_text(type, value);
  if (type == DataType::real || type == DataType::lreal) {
    const auto real = std::bit_cast<double>(value);
    return std::isfinite(real) ? json.value(real) : json.value(text);
  }
  return text.size() < 16 ? json.literal(text) : json.value(text);
}

}  // namespace symplant::view

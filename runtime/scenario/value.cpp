// Reads the values of symbols in a scenario.
#include "symplant/scenario/value.hpp"

#include <nlohmann/json.hpp>

#include "symplant/condition/compare.hpp"
#include "symplant/condition/value.hpp"

namespace symplant::scenario {

std::variant<std::uint64_t, std::string> read_value(tables::DataType type, const nlohmann::json& value) {
  const std::string text = value.dump();
  const std::string shown = "`" + text + "`";
  if (type == tables::DataType::boolean) {
    if (value.is_boolean()) return value.get<bool>() ? 1U : 0U;
    return "expected true or false for a BOOL, but found " + shown;
  }
  if (value.is_boolean()) {
    return "expected a number for " + std::string(condition::type_name(type)) + ", but found " + shown;
  }
  return condition::read_number(type, value.is_string() ? value.get_ref<const std::string&>() : text, shown);
}

}  // namespace symplant::scenario

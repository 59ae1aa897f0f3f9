// Reads the values of symbols in a scenario.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <variant>

#include "symplant/tables/tables.hpp"

namespace symplant::scenario {

/// The value in the representation of its plane, or a message if it is invalid. All values in traces can be read back.
/// BOOL: true and false. Integer types: whole numbers within the range of the type, also as a text
/// (`9007199254740993`, `16#FF`). REAL and LREAL: numbers, rounded to the nearest value of the type, and `nan`, `inf`
/// and `-inf`.
std::variant<std::uint64_t, std::string> read_value(tables::DataType type, const nlohmann::json& value);

}  // namespace symplant::scenario

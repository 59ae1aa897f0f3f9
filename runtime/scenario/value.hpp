// Values of symbols as a scenario writes them.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <variant>

#include "symplant/tables/tables.hpp"

namespace symplant::scenario {

/// The value as a plane holds it, or what is wrong with it. What a trace writes for the type reads back: true and false
/// for BOOL; whole numbers within the range of an integer type, also as a text (`9007199254740993`, `16#FF`); for REAL
/// and LREAL numbers, the nearest value that the type has, also `nan`, `inf` and `-inf`.
std::variant<std::uint64_t, std::string> read_value(tables::DataType type, const nlohmann::json& value);

}  // namespace symplant::scenario

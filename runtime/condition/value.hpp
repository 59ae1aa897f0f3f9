// Reads the value of a numeric symbol.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "symplant/tables/tables.hpp"

namespace symplant::condition {

/// The number in the representation of its plane, or a message that names it as `shown`. Integer types: whole numbers
/// within the range of the type (`9007199254740993`, `16#FF`). REAL and LREAL: numbers, rounded to the nearest value of
/// the type, and `nan`, `inf` and `-inf`. `type` must not be BOOL.
std::variant<std::uint64_t, std::string> read_number(tables::DataType type, std::string_view text,
                                                     const std::string& shown);

}  // namespace symplant::condition

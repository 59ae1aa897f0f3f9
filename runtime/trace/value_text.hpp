// Texts of values and names: JSON, and for people.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "symplant/tables/tables.hpp"

namespace symplant::trace {

/// A text as JSON, with quotes.
std::string json_string(std::string_view text);

/// The value of a symbol as JSON: true or false; a number, or a string if JSON numbers cannot represent it (integers
/// beyond 2^53, NaN, infinities). REAL and LREAL in the shortest form that reads back.
std::string json_value(tables::DataType type, std::uint64_t value);

/// The value of a symbol for people: a number, or what its bit means, as tables::level_text().
std::string value_text(const tables::SymbolRow& symbol, std::uint64_t value);

/// SINT, INT, DINT or LINT.
bool is_signed(tables::DataType type) noexcept;
bool is_real(tables::DataType type) noexcept;
/// Number of bits of the type: 1 to 64.
int width(tables::DataType type) noexcept;

}  // namespace symplant::trace

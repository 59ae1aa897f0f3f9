// The value of a symbol as JSON.
#pragma once

#include <cstdint>

#include "symplant/tables/tables.hpp"
#include "view/json_writer.hpp"

namespace symplant::view {

/// The exact value: integers beyond 2^53, NaN and infinities are strings.
void write_value(tables::DataType type, std::uint64_t value, JsonWriter& json);

}  // namespace symplant::view

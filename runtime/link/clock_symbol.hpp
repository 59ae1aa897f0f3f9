// Which symbols can be the clock of a PLC.
#pragma once

#include <string>

#include "symplant/tables/tables.hpp"

namespace symplant::link {

/// The width of a counter of this type: 16, 32 or 64; 0 if the type cannot be a clock.
int clock_bits(tables::DataType type) noexcept;

/// Why a symbol cannot be a clock, to be read after its name; empty if it can.
std::string clock_fault(tables::DataType type, tables::Direction direction);

}  // namespace symplant::link

// How the rows of elements get their conditions.
#pragma once

#include <cstdint>
#include <functional>

#include "symplant/condition/tree.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::lower {

/// Adds a condition of a row and returns its index.
using AddCondition = std::function<std::uint32_t(const condition::Tree& tree, tables::ReaderKind kind,
                                                 std::uint32_t row, std::uint8_t input)>;

}  // namespace symplant::lower

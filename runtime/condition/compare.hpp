// A comparison of a symbol with a number, folded to what its type can tell apart.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "symplant/condition/number.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::condition {

/// The operand in the form that `number` says, or the constant truth that the comparison comes to.
struct FoldedComparison {
  tables::Comparison comparison;
  tables::NumberKind number;
  std::uint64_t operand;
};

/// Nothing where a REAL or LREAL cannot hold the number. `type` must not be BOOL. O(digits).
std::optional<std::variant<FoldedComparison, bool>> fold(tables::DataType type, tables::Comparison comparison,
                                                         const Number& number);

/// `INT` and so on, as a list has it.
std::string_view type_name(tables::DataType type);

}  // namespace symplant::condition

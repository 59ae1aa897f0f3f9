// Folds the comparison of a symbol with a number to the values that the symbol's type can hold.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "symplant/condition/number.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::condition {

/// A comparison with an operand of the symbol's type; `number` gives the representation of the operand.
struct FoldedComparison {
  tables::Comparison comparison;
  tables::NumberKind number;
  std::uint64_t operand;
};

/// The folded comparison, or a constant if its result is the same for every value of the type. Empty if a REAL or LREAL
/// cannot hold the number. `type` must not be BOOL. O(digits).
std::optional<std::variant<FoldedComparison, bool>> fold(tables::DataType type, tables::Comparison comparison,
                                                         const Number& number);

/// The name of a data type as in a symbol list, such as `INT`.
std::string_view type_name(tables::DataType type);

}  // namespace symplant::condition

// Conditions of `changes`: as all conditions, but with comparisons of two operands (docs/values.md 6).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "support/reference/formula.hpp"
#include "symplant/tables/number.hpp"
#include "symplant/tables/value.hpp"

namespace symplant::reference {

/// A name or a number.
struct CompareOperand {
  std::optional<DottedName> name = {};
  Input input = {};       ///< of a name, after resolve()
  double number = 0;      ///< of a number
  long double exact = 0;  ///< as `number`, for comparisons with integers
};

struct CompareTree {
  enum class Kind : unsigned char { truth, comparison, negation, all, any };
  Kind kind = Kind::truth;
  CompareOperand left = {};  ///< of `truth`: what is true if it is not 0
  tables::Comparison comparison = tables::Comparison::equal;
  CompareOperand right = {};
  std::optional<double> tolerance = {};
  std::vector<CompareTree> children = {};
};

/// Throws std::runtime_error if the text is not a condition.
CompareTree parse_condition(std::string_view text);
bool holds(const CompareTree& tree, const Sight& sight);

/// A comparison of the tables' form. Outputs and slots of `left` and `right` are numbered as in this reference: an
/// output in the order of all outputs, a numeric symbol by its index.
bool holds(const tables::Operand& left, tables::Comparison comparison, const tables::Operand& right, double tolerance,
           const Sight& sight);

}  // namespace symplant::reference

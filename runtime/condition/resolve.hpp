// Resolves the names of a condition to units, states and symbols of a plant.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/condition/expression.hpp"
#include "symplant/condition/names.hpp"
#include "symplant/condition/tree.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::condition {

/// The tree of an expression, or the first name or number in it that does not fit the plant. A symbol or a number of
/// parts compares with a number exactly: a comparison with an integer symbol becomes one with an integer (`x < 3.5` is
/// `x <= 3`), or a constant if no value or every value of the type meets it. All other comparisons, and those with a
/// tolerance, are of doubles. O(expression) look-ups.
std::variant<Tree, Fault> resolve(const Expression& expression, const Names& names);

/// Calls parse(), then resolve().
std::variant<Tree, Fault> parse_and_resolve(std::string_view text, const Names& names);

}  // namespace symplant::condition

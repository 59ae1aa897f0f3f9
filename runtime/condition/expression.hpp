// A condition as its author wrote it: by names, each with its place in the text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/condition/number.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::condition {

/// Bytes of the condition's text.
struct Location {
  std::size_t offset = 0;
  std::size_t length = 0;
};

/// Without its quotes; its place is with them.
struct Name {
  std::string text;
  Location index;
};

/// `negation` has one child, `all` and `any` have two or more, the others none.
struct Expression {
  enum class Kind : unsigned char {
    name,        ///< a symbol, DEVICE.STATE or DEVICE.FACET.STATE: one to three names
    comparison,  ///< a symbol's name, compared with `number`
    negation,
    all,
    any,
  };
  Kind kind = Kind::name;
  std::vector<Name> names;
  tables::Comparison comparison = tables::Comparison::equal;
  Number number;
  Location number_index;
  std::vector<Expression> children;
};

/// What is wrong with a condition, and where.
struct Fault {
  Location index;       ///< of length 0 at the text's end
  std::string message;  ///< what is there, and what was expected
};

inline constexpr std::size_t kDeepestNesting = 256;  ///< parentheses within parentheses

/// Reads a condition:
///
///     condition  = both { "or" both }
///     both       = part { "and" part }
///     part       = { "not" } ( "(" condition ")" | name [ "." name [ "." name ] ] | name comparison number )
///     comparison = "<" | "<=" | "=" | ">=" | ">"
///     name       = letters, digits (Unicode's too) and `_`, or anything in single quotes, a quote doubled
///     number     = as Number::read has it
///
/// Blanks may stand everywhere but within names and numbers. `not`, `and` and `or` are words whatever their ASCII case;
/// a device or symbol of such a name goes in quotes (behind a dot it needs none). O(text); nothing is thrown, whatever
/// the text holds, and the stack is bounded by kDeepestNesting.
std::variant<Expression, Fault> parse(std::string_view text);

}  // namespace symplant::condition

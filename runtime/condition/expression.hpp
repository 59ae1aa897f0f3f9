// A condition as parsed: names and numbers with their locations in the text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/condition/number.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::condition {

/// A range of the condition's text, in bytes.
struct Location {
  std::size_t offset = 0;
  std::size_t length = 0;
};

/// `text` has no quotes; the location includes them.
struct Name {
  std::string text;
  Location index;
};

/// `negation` has one child, `all` and `any` have two or more, the other kinds have no children.
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

/// An error in a condition, and its location.
struct Fault {
  Location index;       ///< of length 0 at the text's end
  std::string message;  ///< what was expected, and what was found
};

inline constexpr std::size_t kDeepestNesting = 256;  ///< levels of nested parentheses

/// Parses a condition:
///
///     condition  = both { "or" both }
///     both       = part { "and" part }
///     part       = { "not" } ( "(" condition ")" | name [ "." name [ "." name ] ] | name comparison number )
///     comparison = "<" | "<=" | "=" | ">=" | ">"
///     name       = letters, digits (of Unicode too) and `_`, or any text in single quotes, with `''` for a quote
///     number     = see Number::read
///
/// Blanks are allowed everywhere except within names and numbers. `not`, `and` and `or` are keywords in any ASCII case;
/// a device or symbol with such a name needs quotes (not after a dot). O(text). An invalid text gives a Fault and no
/// exception; kDeepestNesting bounds the stack.
std::variant<Expression, Fault> parse(std::string_view text);

}  // namespace symplant::condition

// A condition as parsed: names and numbers with their locations in the text.
#pragma once

#include <cstddef>
#include <optional>
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

/// One side of a comparison: a name, maybe with the number of an output, or a number.
struct Operand {
  std::vector<Name> names;     ///< identifiers joined by dots; empty: `number`
  std::optional<Name> output;  ///< the text in `[ ]`
  Number number;
  Location index;  ///< of the whole operand
};

/// `negation` has one child, `all` and `any` have two or more, the other kinds have no children.
struct Expression {
  enum class Kind : unsigned char {
    name,        ///< a symbol, DEVICE.STATE or DEVICE.FACET.STATE: one to three names
    comparison,  ///< the first of two operands, compared with the second one
    negation,
    all,
    any,
  };
  Kind kind = Kind::name;
  std::vector<Name> names;
  std::vector<Operand> operands;  ///< of a comparison: left, right, and the number behind `+-` if there is one
  tables::Comparison comparison = tables::Comparison::equal;
  std::vector<Expression> children;
};

/// An error in a condition, and its location.
struct Fault {
  Location index;        ///< of length 0 at the text's end
  std::string message;   ///< what was expected, and what was found
  bool of_name = false;  ///< of a formula: it is sound, but the plant lacks a name, or has it as something else
};

inline constexpr std::size_t kDeepestNesting = 256;  ///< levels of nested parentheses

/// Parses a condition:
///
///     condition  = both { "or" both }
///     both       = part { "and" part }
///     part       = { "not" } ( "(" condition ")" | comparison | name [ "." name [ "." name ] ] )
///     comparison = operand ( "<" | "<=" | "=" | ">=" | ">" ) operand [ "+-" number ]
///     operand    = number | name { "." name } [ "[" digits "]" ]
///     name       = letters, digits (of Unicode too) and `_`, or any text in single quotes, with `''` for a quote
///     number     = see Number::read
///
/// Blanks are allowed everywhere except within names and numbers. `not`, `and` and `or` are keywords in any ASCII case;
/// a device or symbol with such a name needs quotes (not after a dot), and so does an operand that begins with a name
/// that reads as a number, or the right one if its name begins with a digit. O(text). An invalid text gives a Fault and
/// no exception; kDeepestNesting bounds the stack.
std::variant<Expression, Fault> parse(std::string_view text);

}  // namespace symplant::condition

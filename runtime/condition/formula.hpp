// The language of formulas: from text to steps in postfix form over inputs of a plant.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "symplant/condition/expression.hpp"
#include "symplant/condition/names.hpp"
#include "symplant/condition/tree.hpp"
#include "symplant/tables/tables.hpp"
#include "symplant/tables/value.hpp"

namespace symplant::condition {

/// What a formula reads.
struct FormulaInput {
  enum class Kind : std::uint8_t {
    output,  ///< output `of` of a value
    atom,    ///< 0 or 1: `atom`, which is `settled`, `moving` or `bit`
    number,  ///< numeric symbol `of` of type `type`, after forces
    parts,   ///< the number of parts at location `of`, of kind `part`
    weight,  ///< the sum of the weights of the parts at location `of`
    time,    ///< plant time in seconds
  };
  Kind kind = Kind::time;
  Atom atom;
  std::uint32_t of = 0;
  std::uint32_t part = tables::kNone;                 ///< kNone: all kinds
  tables::DataType type = tables::DataType::boolean;  ///< of `number`

  friend bool operator==(const FormulaInput&, const FormulaInput&) = default;
};

/// In a step, `of` is an index in `inputs` (FormulaOp::input) or in `numbers` (FormulaOp::curve). tables::evaluate()
/// works it out.
struct Formula {
  std::string text;
  std::vector<tables::FormulaStep> steps;
  std::vector<FormulaInput> inputs;  ///< each once, in the order in which the text first names them
  std::vector<double> numbers;       ///< of each curve: how many points, then x and y of each
};

/// Whether a name, in any case of its letters, is a word or a function of formulas. O(functions).
bool is_formula_word(std::string_view name);

/// Parses a formula and looks up its names:
///
///     formula    = both { "or" both }
///     both       = negation { "and" negation }
///     negation   = { "not" } comparison
///     comparison = sum [ ( "<" | "<=" | "=" | ">=" | ">" ) sum ]
///     sum        = product { ( "+" | "-" ) product }
///     product    = unary { ( "*" | "/" ) unary }
///     unary      = { "-" } ( number | "time" | "pi" | input | function "(" formula { "," formula } ")" |
///                            "(" formula ")" )
///     input      = name { "." name } [ "[" digits "]" ]
///     name       = letters, digits and `_`, not first a digit except after a dot, or any text in single quotes, with
///                  `''` for a quote
///     number     = digits [ "." digits ] [ "e" [ "+" | "-" ] digits ]
///
/// Words and functions are in lower case. O(text) and as many look-ups as names. An invalid text gives a Fault and no
/// exception; kDeepestNesting bounds the stack.
std::variant<Formula, Fault> parse_formula(std::string_view text, const Names& names);

}  // namespace symplant::condition

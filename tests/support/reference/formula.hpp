// Formulas of values (docs/values.md): parsed to a tree, and evaluated by walking it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace symplant::reference {

struct Rules;
struct World;

/// What a name in a formula or condition means.
struct Input {
  enum class Kind : std::uint8_t {
    output,   ///< number `part` of the outputs of value `of`
    bit,      ///< BOOL symbol `of`
    number,   ///< numeric symbol `of`
    settled,  ///< unit `of` in state `part`
    moving,   ///< unit `of`
    parts,    ///< at location `of`, of kind `part`; kNone: all
    weight,   ///< of the parts at location `of`
  };
  Kind kind{};
  std::uint32_t of = 0;
  std::uint32_t part = 0;
};

/// A name as written: `BOOM[2]` is {"BOOM"}, 2.
struct DottedName {
  std::vector<std::string> names;
  std::uint32_t index = 0;  ///< 0: none
};

struct Formula {
  enum class Kind : std::uint8_t { number, time, input, call };
  Kind kind = Kind::number;
  double number = 0;
  DottedName name = {};   ///< of `input`
  Input input = {};       ///< of `input`, after resolve()
  std::string call = {};  ///< of `call`: a function or `+ - * / < <= = >= > and or not negate`
  std::vector<Formula> children = {};
};

/// Throws std::runtime_error if the text is not a formula.
Formula parse_formula(std::string_view text);

/// What a formula sees: a world, in which a value that is in the middle of its jumps has another output.
struct Sight {
  const Rules& rules;
  const World& world;
  std::uint32_t jumping = 0xFFFF'FFFF;
  double output = 0;
};

double number_of(const Sight& sight, const Input& input);
double evaluate(const Formula& formula, const Sight& sight);

}  // namespace symplant::reference

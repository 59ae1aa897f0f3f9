// From the text of a formula to postfix steps and inputs, and every kind of invalid text.
#include "symplant/condition/formula.hpp"

#include <numbers>
#include <sstream>

#include "condition_support.hpp"
#include "small_plant.hpp"

namespace symplant::test {
namespace {

using condition::FormulaInput;
using tables::FormulaOp;

std::string input_text(const FormulaInput& input) {
  const std::string of = std::to_string(input.of);
  switch (input.kind) {
    case FormulaInput::Kind::output:
      return "output" + of;
    case FormulaInput::Kind::atom: {
      const std::string unit = std::to_string(input.atom.of);
      if (input.atom.kind == condition::Atom::Kind::bit) return "bit" + unit;
      return "unit" + unit +
             (input.atom.kind == condition::Atom::Kind::moving ? "~" : "@" + std::to_string(input.atom.state));
    }
    case FormulaInput::Kind::number:
      return "slot" + of + (input.type == tables::DataType::int_ ? ":INT" : ":?");
    case FormulaInput::Kind::parts:
      return "parts" + of + (input.part == tables::kNone ? "" : ":" + std::to_string(input.part));
    case FormulaInput::Kind::weight:
      return "weight" + of;
    case FormulaInput::Kind::time:
      return "time";
  }
  return "";
}

/// The steps with their inputs, separated by blanks, or the fault.
std::string steps(std::string_view text) {
  constexpr const char* kOps[] = {
      "",     "",     "neg",  "not",  "+",     "-",     "*",     "/",    "<",    "<=",    "=",   ">=",   ">",
      "and",  "or",   "abs",  "sign", "floor", "ceil",  "round", "sqrt", "exp",  "ln",    "sin", "cos",  "tan",
      "asin", "acos", "atan", "pow",  "mod",   "atan2", "min",   "max",  "wrap", "limit", "if",  "curve"};
  const auto result = condition::parse_formula(text, SmallPlant());
  if (const auto* fault = std::get_if<condition::Fault>(&result)) return text_of(*fault);
  const auto& formula = std::get<condition::Formula>(result);
  CHECK(formula.text == text);
  std::ostringstream out;
  for (const tables::FormulaStep& step : formula.steps) {
    out << (&step == formula.steps.data() ? "" : " ");
    if (step.op == FormulaOp::number) {
      out << step.number;
    } else if (step.op == FormulaOp::input) {
      out << input_text(formula.inputs.at(step.of));
    } else {
      out << kOps[static_cast<std::size_t>(step.op)];
    }
    if (step.op != FormulaOp::curve) continue;
    const auto count = static_cast<std::size_t>(formula.numbers.at(step.of));
    for (std::size_t i = 0; i < count; ++i) {
      out << "|" << formula.numbers.at(step.of + 1 + 2 * i) << ":" << formula.numbers.at(step.of + 2 + 2 * i);
    }
  }
  return out.str();
}

TEST_CASE("Operators bind from `or` to the unary minus and group from the left") {
  CHECK(steps("1 or 2 and not 3 < 4 + 5 * -flow") == "1 2 3 4 5 output1 neg * + < not and or");
  CHECK(steps("1 - 2 - 3") == "1 2 - 3 -");
  CHECK(steps("8 / 4 * 2") == "8 4 / 2 *");
  CHECK(steps("8 / (4 * 2)") == "8 4 2 * /");
  CHECK(steps("1 or 2 or 3 and 4 and 5") == "1 2 or 3 4 and 5 and or");
  CHECK(steps("not not 1 = 2") == "1 2 = not not");
  CHECK(steps("(1 < 2) = (3 >= 4)") == "1 2 < 3 4 >= =");
  CHECK(steps("1 <= 2 and 3 > 2") == "1 2 <= 3 2 > and");
  CHECK(steps("-(not 1)") == "1 not neg");
}

TEST_CASE("A minus before a number is its sign") {
  CHECK(steps("-5") == "-5");
  CHECK(steps("--5") == "5");
  CHECK(steps("3 - -5") == "3 -5 -");
  CHECK(steps("--flow") == "output1 neg neg");
  CHECK(steps("-0") == "-0");
}

TEST_CASE("A number is decimal, with a fraction and an exponent") {
  CHECK(steps("12") == "12");
  CHECK(steps("0.5") == "0.5");
  CHECK(steps("1e-3") == "0.001");
  CHECK(steps("2.5E+2") == "250");
  CHECK(steps("1e3-1") == "1000 1 -");
  const auto third = condition::parse_formula("0.1", SmallPlant());
  CHECK(std::get<condition::Formula>(third).steps.at(0).number == 0.1);
  const auto pi = condition::parse_formula("pi", SmallPlant());
  CHECK(std::get<condition::Formula>(pi).steps.at(0).number == std::numbers::pi);
}

TEST_CASE("A name is what it is in the plant") {
  CHECK(steps("TANK.level") == "output0");
  CHECK(steps("'TANK' . level") == "output0");
  CHECK(steps("BOOM[1] + BOOM[ 3 ]") == "output2 output4 +");
  CHECK(steps("LEVEL") == "slot8:INT");
  CHECK(steps("START") == "bit7");
  CHECK(steps("AGV.P2") == "unit0@1");
  CHECK(steps("DOOR.LOCK.SHUT") == "unit2@0");
  CHECK(steps("LIFT.DOWN") == "unit4@1");
  CHECK(steps("AGV.moving") == "unit0~");
  CHECK(steps("CV1.parts") == "parts0");
  CHECK(steps("BOX.part") == "parts1");
  CHECK(steps("BOX.done") == "parts1:1");
  CHECK(steps("CV1.weight") == "weight0");
  CHECK(steps("time") == "time");
  CHECK(steps("2 * pi * time") == "2 3.14159 * time *");
}

TEST_CASE("An input is in the list once") {
  const auto result = condition::parse_formula("flow + time * flow + AGV.P1 - AGV.P1 + AGV.P2 + time", SmallPlant());
  const auto& formula = std::get<condition::Formula>(result);
  REQUIRE(formula.inputs.size() == 4);
  CHECK(formula.inputs[0].kind == FormulaInput::Kind::output);
  CHECK(formula.inputs[1] == FormulaInput{});
  CHECK(formula.inputs[2].atom.state == 0);
  CHECK(formula.inputs[3].atom.state == 1);
}

TEST_CASE("Functions have their arguments in order") {
  CHECK(steps("sqrt(abs(flow))") == "output1 abs sqrt");
  CHECK(steps("atan2(1, 2) + pow(3, 4) + mod(5, 6)") == "1 2 atan2 3 4 pow + 5 6 mod +");
  CHECK(steps("min(1, 2, 3, 4)") == "1 2 min 3 min 4 min");
  CHECK(steps("max(1, 2)") == "1 2 max");
  CHECK(steps("wrap(1, 2, 3) + limit (4, 5, 6)") == "1 2 3 wrap 4 5 6 limit +");
  CHECK(steps("if(flow > 1, 2, if(0, 3, 4))") == "output1 1 > 2 0 3 4 if if");
  CHECK(steps("curve(flow, -1, 5, 0, -2.5) + curve(1, 0, 0, 1, 1, 2, 4)") ==
        "output1 curve|-1:5|0:-2.5 1 curve|0:0|1:1|2:4 +");
  for (const char* name :
       {"sign", "floor", "ceil", "round", "exp", "ln", "sin", "cos", "tan", "asin", "acos", "atan"}) {
    CHECK(steps(std::string(name) + "(1)") == "1 " + std::string(name));
  }
}

TEST_CASE("An invalid formula reports what was found and what was expected") {
  const std::pair<const char*, const char*> cases[] = {
      {"", "0+0 expected a number, a name or `(`, but the formula ends"},
      {"1 +", "3+0 expected a number, a name or `(`, but the formula ends"},
      {"1 2", "2+1 expected an operator or the end, but found `2`"},
      {"flow flow", "5+4 expected an operator or the end, but found `flow`"},
      {"(1", "2+0 expected an operator or `)`, but the formula ends"},
      {"1)", "1+1 expected an operator or the end, but found `)`"},
      {"abs(1 2)", "6+1 expected an operator, `,` or `)`, but found `2`"},
      {"1 < 2 < 3", "6+1 comparisons do not chain; write `a < b and b < c`"},
      {"1 = 2 >= 3", "6+2 comparisons do not chain; write `a < b and b < c`"},
      {"1 == 2", "3+1 expected a number, a name or `(`, but found `=`; equal is `a = b`"},
      {"1 <> 2", "3+1 expected a number, a name or `(`, but found `>`; not equal is `not a = b`"},
      {"1 != 2", "2+1 expected an operator or the end, but found `!`; not equal is `not a = b`"},
      {"2 ^ 3", "2+1 expected an operator or the end, but found `^`; write `pow(x, y)`"},
      {"2 ** 3", "3+1 expected a number, a name or `(`, but found `*`; a power is `pow(x, y)`"},
      {"2 % 3", "2+1 expected an operator or the end, but found `%`; write `mod(x, y)`"},
      {"1 && 2", "2+1 expected an operator or the end, but found `&`; write `and`"},
      {".5", "0+1 expected a number, a name or `(`, but found `.`; write 0 before it, as in `0.5`"},
      {"1 AND 2", "2+3 expected an operator or the end, but found `AND`; words are in lower case, write `and`"},
      {"NOT 1", "0+3 symbol `NOT` not found; words are in lower case, write `not`"},
      {"Pi", "0+2 symbol `Pi` not found; words are in lower case, write `pi`"},
      {"1 + not 2", "4+3 expected a number, a name or `(`, but found `not`; put `not` and what follows in parentheses"},
      {"or", "0+2 expected a number, a name or `(`, but found `or`"},
      {"3x",
       "0+2 `3x` is not a number; write it as in `12`, `0.5` or `1e-3`, and a name that begins with a digit in single "
       "quotes"},
      {"1e999", "0+5 the number `1e999` is out of the range of a double"},
      {"1e-999", "0+6 the number `1e-999` is out of the range of a double"},
      {"'flow", "0+1 this quote is not closed; add a `'` after the name"},
      {"AGV.", "4+0 expected a name, but the formula ends"},
      {"AGV.+", "4+1 expected a name, but found `+`"},
      {"''", "0+2 expected a name, but found `''`"},
      {"flow @", "5+1 expected an operator or the end, but found `@`"},
  };
  for (const auto& [text, fault] : cases) {
    INFO(text);
    CHECK(steps(text) == fault);
  }
  for (const char* text : {"1.", "1.x", "16#FF", "0x1F", "1_000", "1e", "1e+", "1.5.2", "1..2"}) {
    CHECK(steps(text).find(" is not a number; write it as in `12`") != std::string::npos);
  }
}

TEST_CASE("A function has the right number of arguments") {
  CHECK(steps("abs()") == "0+3 `abs` takes 1 argument, as in `abs(x)`, but has 0");
  CHECK(steps("1 + pow(1)") == "4+3 `pow` takes 2 arguments, as in `pow(x, y)`, but has 1");
  CHECK(steps("atan2(1, 2, 3)") == "0+5 `atan2` takes 2 arguments, as in `atan2(y, x)`, but has 3");
  CHECK(steps("min(1)") == "0+3 `min` takes 2 or more arguments, as in `min(a, b)`, but has 1");
  CHECK(steps("max()") == "0+3 `max` takes 2 or more arguments, as in `max(a, b)`, but has 0");
  CHECK(steps("if(1, 2)") == "0+2 `if` takes 3 arguments, as in `if(condition, then, else)`, but has 2");
  CHECK(steps("limit(1, 2, 3, 4)") == "0+5 `limit` takes 3 arguments, as in `limit(x, low, high)`, but has 4");
  CHECK(steps("abs(1,)") == "6+1 expected a number, a name or `(`, but found `)`");
  CHECK(steps("flor(1)") == "0+4 function `flor` not found; did you mean `floor`?");
  CHECK(steps("SQRT(1)") == "0+4 function `SQRT` not found; did you mean `sqrt`?");
  CHECK(steps("blub(1)") == "0+4 function `blub` not found");
  CHECK(steps("sin + 1") == "0+3 symbol `sin` not found; the function is `sin(x)`");
  CHECK(steps("'sin'(1)") == "0+5 symbol `sin` not found");
}

TEST_CASE("The points of a curve are numbers, ascending in x") {
  const std::string usage = "0+5 `curve` takes x and two or more points, as in `curve(x, x0, y0, x1, y1)`, but has ";
  CHECK(steps("curve()") == usage + "0 numbers for x and y of points");
  CHECK(steps("curve(1)") == usage + "0 numbers for x and y of points");
  CHECK(steps("curve(1, 2, 3)") == usage + "2 numbers for x and y of points");
  CHECK(steps("curve(1, 2, 3, 4, 5, 6)") == usage + "5 numbers for x and y of points");
  CHECK(steps("curve(1, 0, 0, flow, 1)") ==
        "15+4 expected a number, but found `flow`; the points of `curve` are numbers");
  CHECK(steps("curve(1, 0, 0, --1, 1)") == "16+1 expected a number, but found `-`; the points of `curve` are numbers");
  CHECK(steps("curve(1, 0, 0, 1 + 1, 1)") == "17+1 expected `,` or `)`, but found `+`");
  const std::string sort = " x of this point is not above that of the point before; sort the points of `curve` by x";
  CHECK(steps("curve(1, 2, 0, 1, 1)") == "15+1" + sort);
  CHECK(steps("curve(1, 2, 0, 2, 1)") == "15+1" + sort);
  CHECK(steps("curve(1, -1, 0, 1, 0, -2, 1)") == "23+1" + sort);
}

TEST_CASE("A name that does not fit the plant is reported with the nearest one") {
  CHECK(steps("flw") == "0+3 symbol `flw` not found; did you mean `flow`?");
  CHECK(steps("STRAT") == "0+5 symbol `STRAT` not found; did you mean `START`?");
  CHECK(steps("1 + TANK.levl") == "4+9 value `TANK.levl` not found; did you mean `TANK.level`?");
  CHECK(steps("AGV.P9") == "4+2 state `P9` of `AGV` not found; did you mean `P1`?");
  CHECK(steps("AGW.P1") == "0+3 device `AGW` not found; did you mean `AGV`?");
  CHECK(steps("AGV.BUSY") == "4+4 `BUSY` is only an event");
  CHECK(steps("BOX.rew") == "4+3 kind of part `rew` not found; did you mean `raw`?");
  CHECK(steps("AGV") == "0+3 `AGV` is a device; name one of its states, as in `AGV.STATE`");
  CHECK(steps("BOX") == "0+3 `BOX` is a track or place of parts; write `BOX.part`");
  CHECK(steps("BOX.a.parts") == "0+11 `BOX` is a track or place of parts; write `BOX.part`");
  CHECK(steps("LIFT.UP") == "0+7 `LIFT.UP` is in several facets of the device; write `LIFT.A.UP`, `LIFT.B.UP`");
  CHECK(steps("A.B.C.D") == "0+7 `A.B.C.D` not found");
  CHECK(steps("BOOM") == "0+4 `BOOM` has 3 outputs; write one of `BOOM[1]` to `BOOM[3]`");
  CHECK(steps("BOOM[4]") == "5+1 `BOOM` has 3 outputs; write one of `BOOM[1]` to `BOOM[3]`");
  CHECK(steps("BOOM[99999999999]") == "5+11 `BOOM` has 3 outputs; write one of `BOOM[1]` to `BOOM[3]`");
  CHECK(steps("BOOM[flow + 1]") == "10+1 expected `]`, but found `+`");
  CHECK(steps("BOOM[]") == "5+1 expected the number of an output, but found `]`");
  CHECK(steps("flow[1]") == "5+1 `flow` has one output; write it without `[1]`");
  CHECK(steps("LEVEL[1]") == "6+1 only a value of kind `linear` has several outputs; remove `[1]`");
  CHECK(steps("flw[1]") == "0+3 symbol `flw` not found; did you mean `flow`?");
}

TEST_CASE("A fault says whether a name does not fit the plant, or the text is invalid") {
  const auto unknown = [](std::string_view text) {
    const auto formula = condition::parse_formula(text, SmallPlant());
    return std::get<condition::Fault>(formula).of_name;
  };
  CHECK(unknown("1 + flw"));
  CHECK(unknown("AGV.P9"));
  CHECK(unknown("BOOM[4]"));
  CHECK_FALSE(unknown("1 +"));
  CHECK_FALSE(unknown("flor(1)"));
  CHECK_FALSE(unknown("1e999"));
}

TEST_CASE("Nesting is limited, chains are not") {
  const std::string open(256, '(');
  const std::string close(256, ')');
  CHECK(steps(open + "1" + close) == "1");
  CHECK(steps("(" + open + "1" + close + ")") == "256+1 more than 256 nested parentheses");
  std::string calls;
  for (int i = 0; i < 300; ++i) calls += "abs(";
  CHECK(steps(calls) == "1027+1 more than 256 nested parentheses");
  std::string side_by_side = "(1)";
  for (int i = 0; i < 1000; ++i) side_by_side += "+(1)";
  CHECK(condition::parse_formula(side_by_side, SmallPlant()).index() == 0);
  CHECK(condition::parse_formula(std::string(100'000, '-') + "flow", SmallPlant()).index() == 0);
  std::string negations;
  for (int i = 0; i < 100'000; ++i) negations += "not ";
  CHECK(condition::parse_formula(negations + "flow", SmallPlant()).index() == 0);
}

TEST_CASE("A formula never holds more than 64 numbers") {
  const auto nested = [](int levels) {
    std::string text;
    for (int i = 0; i < levels; ++i) text += "1+(";
    return text + "1" + std::string(static_cast<std::size_t>(levels), ')');
  };
  CHECK(condition::parse_formula(nested(63), SmallPlant()).index() == 0);
  CHECK(
      steps(nested(64)) ==
      "193+1 the formula is too nested here: it would hold more than 64 numbers at a time; make a part of it a value");
}

}  // namespace
}  // namespace symplant::test

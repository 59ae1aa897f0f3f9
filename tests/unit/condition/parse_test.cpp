// From text to an expression by names: the grammar, and every kind of invalid text.
#include "condition_support.hpp"

namespace symplant::test {
namespace {

TEST_CASE("A condition is a name, with a state, or with a facet and a state") {
  CHECK(parsed("L_P_D_O_A") == "L_P_D_O_A");
  CHECK(parsed("L_P_D.A") == "L_P_D.A");
  CHECK(parsed("L_P_D.CLAMP.A") == "L_P_D.CLAMP.A");
  CHECK(parsed(" L_P_D . A ") == "L_P_D.A");
}

TEST_CASE("`not` binds before `and`, `and` before `or`") {
  CHECK(parsed("a or b and not c or d") == "(or a (and b (not c)) d)");
  CHECK(parsed("not a and b") == "(and (not a) b)");
  CHECK(parsed("(a or b) and c") == "(and (or a b) c)");
  CHECK(parsed("not (a or b)") == "(not (or a b))");
  CHECK(parsed("not x < 3") == "(not x<3e0)");
}

TEST_CASE("A double `not` cancels") {
  CHECK(parsed("not not a") == "a");
  CHECK(parsed("not not not a") == "(not a)");
  CHECK(parsed("not (not a)") == "(not (not a))");
}

TEST_CASE("Keywords ignore case, a name that equals one is in quotes or after a dot") {
  CHECK(parsed("NOT a And b OR c") == "(or (and (not a) b) c)");
  CHECK(parsed("'not' and 'AND'") == "(and not AND)");
  CHECK(parsed("D.OR or D.not") == "(or D.OR D.not)");
  CHECK(parsed("android and notes") == "(and android notes)");
}

TEST_CASE("Every comparison is parsed, with numbers in every notation") {
  CHECK(parsed("x < 3") == "x<3e0");
  CHECK(parsed("x<=-3.5") == "x<=-35e-1");
  CHECK(parsed("x = 1_000") == "x=1e3");
  CHECK(parsed("x>=16#FF") == "x>=255e0");
  CHECK(parsed("x > 2.5e-3 or y < 1") == "(or x>25e-4 y<1e0)");
}

TEST_CASE("Names have letters, digits and underscores of any script") {
  CHECK(parsed("3D_P_Ä.日本1") == "3D_P_Ä.日本1");
  CHECK(parsed("1.2") == "1.2");
  CHECK(parsed("ÄÖ　and　x") == "(and ÄÖ x)");  // separated by ideographic blanks
}

TEST_CASE("A name that is not an identifier is in quotes, with quotes doubled") {
  CHECK(parsed("'S441-2 V1'.OPEN") == "S441-2 V1.OPEN");
  CHECK(parsed("D.'it''s (open'") == "D.it's (open");
  CHECK(parsed("''''") == "'");
}

TEST_CASE("Every name has its location, quotes included, in bytes") {
  const auto result = condition::parse("not 'Ä b'.OPEN and xy < 12");
  const auto& both = std::get<condition::Expression>(result);
  const condition::Expression& state = both.children.at(0).children.at(0);
  CHECK(state.names.at(0).index.offset == 4);
  CHECK(state.names.at(0).index.length == 6);
  CHECK(state.names.at(1).index.offset == 11);
  CHECK(state.names.at(1).index.length == 4);
  const condition::Expression& comparison = both.children.at(1);
  CHECK(comparison.operands.at(0).names.at(0).index.offset == 20);
  CHECK(comparison.operands.at(1).index.offset == 25);
  CHECK(comparison.operands.at(1).index.length == 2);
}

TEST_CASE("An invalid condition reports what was found and what was expected") {
  const std::pair<const char*, const char*> cases[] = {
      {"", "0+0 expected a name, `not` or `(`, but the condition ends"},
      {"   ", "3+0 expected a name, `not` or `(`, but the condition ends"},
      {"a b", "2+1 expected `and`, `or` or the end, but found `b`"},
      {"a and", "5+0 expected a name, `not` or `(`, but the condition ends"},
      {"a and or b", "6+2 expected a name, `not` or `(`, but found `or`"},
      {"or", "0+2 expected a name, `not` or `(`, but found `or`"},
      {"not", "3+0 expected a name or `(`, but the condition ends"},
      {"(a or b", "7+0 expected `and`, `or` or `)`, but the condition ends"},
      {"a)", "1+1 expected `and`, `or` or the end, but found `)`"},
      {"()", "1+1 expected a name, `not` or `(`, but found `)`"},
      {"D.", "2+0 expected a name, but the condition ends"},
      {"D..A", "2+1 expected a name, but found `.`"},
      {"A.B.C.D", "5+1 expected `and`, `or` or the end, but found `.`"},
      {"x <", "3+0 expected a number, but the condition ends"},
      {"x == 3", "3+1 expected a number, but found `=`"},
      {"x < 3x", "4+2 expected a number, but found `3x`"},
      {"3 < x 4", "6+1 expected `and`, `or` or the end, but found `4`"},
      {"-3", "0+1 expected a name, `not` or `(`, but found `-`"},
      {"x = 3 +- y", "9+1 expected a number, but found `y`"},
      {"x < y[", "6+0 expected the number of an output, but the condition ends"},
      {"x < y[1", "7+0 expected `]`, but the condition ends"},
      {"x[1]", "1+1 an output of a value has no comparison; compare it, as in `NAME[1] = 1`"},
      {"S441-2.A", "4+1 expected `and`, `or` or the end, but found `-`"},
      {"a ∧ b", "2+3 expected `and`, `or` or the end, but found `∧`"},
      {"a and 'b", "6+1 this quote is not closed; add a `'` after the name"},
      {"''", "0+2 expected a name, `not` or `(`, but found `''`"},
      {"a \xFF", "0+3 the condition is not valid UTF-8"},
  };
  for (const auto& [text, fault] : cases) {
    INFO(text);
    CHECK(parsed(text) == fault);
  }
}

TEST_CASE("A comparison has two operands: names of any length, outputs and numbers") {
  CHECK(parsed("TANK.level >= 99") == "TANK.level>=99e0");
  CHECK(parsed("80 < TANK.level and -2.5 = x") == "(and 8e1<TANK.level -25e-1=x)");
  CHECK(parsed("pieces >= B_S1_CNT_O_SIZE") == "pieces>=B_S1_CNT_O_SIZE");
  CHECK(parsed("A.B.C.D.E < 'a b'.c") == "A.B.C.D.E<a b.c");
  CHECK(parsed("BOOM[2] > BOOM [ 10 ]") == "BOOM[2]>BOOM[10]");
  CHECK(parsed("TANK.level = 80 +- 1") == "TANK.level=8e1+-1e0");
  CHECK(parsed("not a = -1 +-0.5 or b") == "(or (not a=-1e0+-5e-1) b)");
  CHECK(parsed("3D_X.Y < '3D'") == "3D_X.Y<3D");
  CHECK(parsed("1.2 < 3") == "12e-1<3e0");
  CHECK(parsed("'1'.2 < 3") == "1.2<3e0");
}

TEST_CASE("A formula in a condition proposes a value") {
  const std::string hint =
      "; a condition does not calculate: make the formula a value, as in `\"sum\": { \"is\": \"a + b\" }`, and compare "
      "that";
  CHECK(parsed("TANK.level + 1 > 3") == "11+1 expected `and`, `or` or the end, but found `+`" + hint);
  CHECK(parsed("x > 3 * y") == "6+1 expected `and`, `or` or the end, but found `*`" + hint);
  CHECK(parsed("(x / 2) > 3") == "3+1 expected `and`, `or` or `)`, but found `/`" + hint);
  CHECK(parsed("sqrt(x) > 3") == "4+1 expected `and`, `or` or the end, but found `(`" + hint);
  CHECK(parsed("S441-2 > 3") ==
        "4+1 expected `and`, `or` or the end, but found `-`" + hint + ", or put a name with `-` in single quotes");
  CHECK(parsed("x + y") == "2+1 expected `and`, `or` or the end, but found `+`");
  CHECK(parsed("x + '<'") == "2+1 expected `and`, `or` or the end, but found `+`");
}

TEST_CASE("Parentheses nest up to 256 deep, and those in quotes do not count") {
  const std::string open(256, '(');
  const std::string close(256, ')');
  CHECK(parsed(open + "a" + close) == "a");
  CHECK(parsed("(" + open + "a" + close + ")") == "256+1 more than 256 nested parentheses");
  CHECK(parsed("'" + open + open + "'") == open + open);
  CHECK(parsed("x or " + std::string(300, '(')) == "261+1 more than 256 nested parentheses");
  std::string side_by_side = "(a)";
  for (int i = 0; i < 1000; ++i) side_by_side += " and (a)";
  CHECK(condition::parse(side_by_side).index() == 0);
}

TEST_CASE("A condition of a million words is read without deep recursion") {
  std::string text = "a";
  for (int i = 0; i < 100'000; ++i) text += " or not not not b";
  const auto result = condition::parse(text);
  CHECK(std::get<condition::Expression>(result).children.size() == 100'001);
}

}  // namespace
}  // namespace symplant::test

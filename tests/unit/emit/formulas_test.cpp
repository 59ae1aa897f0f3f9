// Formulas as C++ functions: their text. That they give the same bits is a test of tests/compiled.
#include "emit_support.hpp"
#include "support/described_plant.hpp"

namespace symplant::test {
namespace {

/// The functions of a plant with these values.
std::string functions_of(const std::string& values) {
  const DescribedPlant plant({{"L_P_CV_O_RUN", "", "BOOL", "", "%QX0"},
                              {"L_P_CV_I_RUN", "", "BOOL", "", "%IX0"},
                              {"SPEED", "", "INT", "0", "%QW3"},
                              {"COUNT", "", "INT", "0", "%IW3"}},
                             "\"values\": " + values);
  return file_of(emitted(plant.compiled().plant, plant.compiled().tables), "formulas_gen.hpp");
}

/// The expression of a value `x` that is this formula, where a, b and c are parameters.
std::string expression_of(const std::string& formula) {
  INFO(formula);
  const std::string text = functions_of(R"({"a": {}, "b": {}, "c": {}, "x": {"is": ")" + formula + "\"}}");
  const std::string from = "    return ";
  const std::size_t begin = text.find(from);
  REQUIRE(begin != text.npos);
  return text.substr(begin + from.size(), text.find(";\n", begin) - begin - from.size());
}

TEST_CASE("Parentheses are only where the order of operations needs them") {
  CHECK(expression_of("a + b - c") == "a + b - c");
  CHECK(expression_of("a - (b - c)") == "a - (b - c)");
  CHECK(expression_of("a - (b * c)") == "a - b * c");
  CHECK(expression_of("(a + b) * c") == "(a + b) * c");
  CHECK(expression_of("a / (b * c)") == "a / (b * c)");
  CHECK(expression_of("a / b * c") == "a / b * c");
  CHECK(expression_of("-a * -b") == "-a * -b");
  CHECK(expression_of("-(a + b)") == "-(a + b)");
  CHECK(expression_of("--a") == "-(-a)");
  CHECK(expression_of("2 * a + 1e30") == "2.0 * a + 1e+30");
}

TEST_CASE("A comparison is a bool where a condition is needed, and a number elsewhere") {
  CHECK(expression_of("a < b") == "formula::truth(a < b)");
  CHECK(expression_of("a = b") == "formula::truth(a == b)");
  CHECK(expression_of("2 * (a >= b)") == "2.0 * formula::truth(a >= b)");
  CHECK(expression_of("a < b and c") == "formula::truth(a < b && c != 0.0)");
  CHECK(expression_of("a and b or c") == "formula::truth((a != 0.0 && b != 0.0) || c != 0.0)");
  CHECK(expression_of("(a or b) and not c") == "formula::truth((a != 0.0 || b != 0.0) && !(c != 0.0))");
  CHECK(expression_of("not (a < b)") == "formula::truth(!(a < b))");
  CHECK(expression_of("a + b or c") == "formula::truth(a + b != 0.0 || c != 0.0)");
  CHECK(expression_of("(a < b) <= c") == "formula::truth(formula::truth(a < b) <= c)");
  CHECK(expression_of("if(a > 0, b, c)") == "a > 0.0 ? b : c");
  CHECK(expression_of("1 + if(a, b, if(b, c, a < b))") ==
        "1.0 + (a != 0.0 ? b : (b != 0.0 ? c : formula::truth(a < b)))");
}

TEST_CASE("Functions of formulas are called") {
  CHECK(expression_of("max(a, b, c)") == "formula::max(formula::max(a, b), c)");
  CHECK(expression_of("limit(a + 1, 0, pow(b, 2))") == "formula::limit(a + 1.0, 0.0, formula::pow(b, 2.0))");
  CHECK(expression_of("curve(a, 0, 1, 2.5, 3)") == "formula::curve(a, {0.0, 1.0, 2.5, 3.0})");
  CHECK(expression_of("ln(abs(a < b))") == "formula::ln(formula::abs(formula::truth(a < b)))");
}

TEST_CASE("A function has the names of what the formula reads, and its text and unit above") {
  const std::string text = functions_of(R"({
      "TANK.level": {"unit": "l", "integral": "SPEED * L_P_CV.RUN - TANK.level", "changes": [{"when": "L_P_CV_O_RUN", "to": "0"}]},
      "axis": {"unit": "m/s */", "ramp": "time + TANK.level", "up": 2, "down": "COUNT"},
      "ctl": {"pid": {"of": "axis", "to": "class", "kp": 1}},
      "class": {},
      "boom": {"linear": {"a": [[1]], "b": [[1, 1]], "c": [[1], [2]], "u": ["axis", "boom[2]"]}},
      "formula": {"is": "boom[1]"}})");
  const auto has = [&](const std::string& part) {
    INFO(part << "\n" << text);
    CHECK(contains(text, part));
  };
  has("  /// TANK.level (l), integral: SPEED * L_P_CV.RUN - TANK.level\n"
      "  static double tank_level(double speed, double l_p_cv_run, double tank_level) noexcept {\n"
      "    return speed * l_p_cv_run - tank_level;\n  }\n");
  has("  /// TANK.level (l), integral, to: 0\n  static double tank_level_to() noexcept {\n    return 0.0;\n  }\n");
  has("static double axis(double time, double tank_level) noexcept");
  has("static double axis_up() noexcept");
  has("static double axis_down(double count) noexcept");
  has("static double ctl_of(double axis) noexcept");
  has("static double ctl_to(double class_) noexcept");
  has("static double boom_u2(double boom_2) noexcept");
  has("static double formula_2(double boom_1) noexcept");
  has("    compiled_formula<&Formulas::axis_down, &ModelFormulas::axis_down>(),\n");
}

TEST_CASE("Values get the names of their functions before what other values have in addition") {
  const std::string text = functions_of(R"({"r": {"unit": "m/s", "ramp": "1", "up": 2}, "r.up": {"is": "3"}})");
  CHECK(contains(text, "/// r.up, is: 3\n  static double r_up() noexcept"));
  CHECK(contains(text, "/// r (m/s), ramp, up: 2\n  static double r_up_2() noexcept"));
}

TEST_CASE("A position has no function: its number follows from its device") {
  const std::string text =
      functions_of(R"({"a": {"is": "1"}, "at": {"position": "L_P_CV", "at": {"RUN": 5, "NOT_RUN": 1}}})");
  CHECK(!contains(text, "static double at("));
  CHECK(contains(text, "    {},  // a position\n"));
}

TEST_CASE("A plant without formulas has no functions") {
  const std::string text = functions_of("{}");
  CHECK(!contains(text, "ModelFormulas"));
}

TEST_CASE("The class of the plant gives values by name, and sets those that can be set") {
  const DescribedPlant plant({{"L_P_CV_O_RUN", "", "BOOL", "", "%QX0"}, {"L_P_CV_I_RUN", "", "BOOL", "", "%IX0"}},
                             R"("values": {"CV": {}, "TANK.level": {"integral": "1"}, "weight": {"is": "2"},
                                "boom": {"linear": {"a": [[1]], "b": [[1]], "c": [[1], [2]], "u": ["1"]}}})");
  const std::string text = file_of(emitted(plant.compiled().plant, plant.compiled().tables), "plant_gen.hpp");
  CHECK(contains(text, "  double cv_2() const noexcept { return output(0); }  // CV\n"));  // cv() is the device
  CHECK(contains(text, "  double tank_level() const noexcept { return output(1); }  // TANK.level\n"));
  CHECK(contains(text, "  double weight_2() const noexcept { return output(2); }  // weight\n"));  // as Plant::weight
  CHECK(contains(text, "  double boom_2() const noexcept { return output(4); }  // boom[2]\n"));
  CHECK(contains(text, "  bool set_tank_level(double number) noexcept { return set_value(1, number); }\n"));
  CHECK(!contains(text, "set_weight"));
}

}  // namespace
}  // namespace symplant::test

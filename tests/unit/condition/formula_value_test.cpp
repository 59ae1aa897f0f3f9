// The results of formulas, to the bit.
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "condition_support.hpp"
#include "small_plant.hpp"
#include "symplant/condition/formula.hpp"
#include "symplant/tables/formula.hpp"

namespace symplant::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The result with inputs in the order in which the formula names them.
double value(std::string_view text, const std::vector<double>& inputs = {}) {
  INFO(text);
  const auto result = condition::parse_formula(text, SmallPlant());
  REQUIRE(result.index() == 0);
  const auto& formula = std::get<condition::Formula>(result);
  REQUIRE(formula.inputs.size() == inputs.size());
  return tables::evaluate(formula.steps, formula.numbers, inputs.data());
}

/// Equal bits; every NaN is the same.
bool same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST_CASE("Arithmetic is that of doubles, in the order of the text") {
  CHECK(same(value("0.1 + 0.2"), 0.30000000000000004));
  CHECK(same(value("1e308 * 10 / 10"), kInfinity));
  CHECK(same(value("1 - 2 - 3"), -4));
  CHECK(same(value("7 / 2 * 2"), 7));
  CHECK(same(value("1e16 + 1 + 1"), 1e16));
  CHECK(same(value("1e16 + (1 + 1)"), 10000000000000002.0));
  CHECK(same(value("1 / 0"), kInfinity));
  CHECK(same(value("-1 / 0"), -kInfinity));
  CHECK(same(value("0 / 0"), kNaN));
  CHECK(same(value("1 / -0"), -kInfinity));
  CHECK(same(value("-flow", {0}), -0.0));
  CHECK(same(value("0 - flow", {0}), 0.0));
  // Fused, the product would not be rounded, and the result not 0.
  CHECK(same(value("flow * flow - LEVEL", {1 + 0x1p-30, (1 + 0x1p-30) * (1 + 0x1p-30)}), 0));
}

TEST_CASE("Comparisons give 0 or 1, and 0 with NaN") {
  CHECK(same(value("1 < 2"), 1));
  CHECK(same(value("2 < 2"), 0));
  CHECK(same(value("2 <= 2"), 1));
  CHECK(same(value("3 <= 2"), 0));
  CHECK(same(value("2 = 2"), 1));
  CHECK(same(value("0 = -0"), 1));
  CHECK(same(value("2 = 3"), 0));
  CHECK(same(value("2 >= 2"), 1));
  CHECK(same(value("1 >= 2"), 0));
  CHECK(same(value("3 > 2"), 1));
  CHECK(same(value("2 > 2"), 0));
  for (const char* sign : {"<", "<=", "=", ">=", ">"}) {
    CHECK(same(value("flow " + std::string(sign) + " 1", {kNaN}), 0));
    CHECK(same(value("1 " + std::string(sign) + " flow", {kNaN}), 0));
    CHECK(same(value("flow " + std::string(sign) + " flow", {kNaN}), 0));
  }
}

TEST_CASE("A number is true if it is not 0, and NaN is true") {
  CHECK(same(value("2 and -3"), 1));
  CHECK(same(value("2 and 0"), 0));
  CHECK(same(value("-0 or 0"), 0));
  CHECK(same(value("0 or 0.1"), 1));
  CHECK(same(value("flow and 1", {kNaN}), 1));
  CHECK(same(value("0 or flow", {kNaN}), 1));
  CHECK(same(value("not flow", {kNaN}), 0));
  CHECK(same(value("not 0"), 1));
  CHECK(same(value("not 5"), 0));
  CHECK(same(value("not not 5"), 1));
  CHECK(same(value("if(flow, 2, 3)", {kNaN}), 2));
  CHECK(same(value("if(0, 2, 3)"), 3));
  CHECK(same(value("if(-1, 2, flow)", {kNaN}), 2));
  CHECK(same(value("2 + (flow > 3) * 4", {5}), 6));
}

TEST_CASE("Functions of one argument") {
  CHECK(same(value("abs(-0)"), 0.0));
  CHECK(same(value("abs(-2.5)"), 2.5));
  CHECK(same(value("sign(-3)"), -1));
  CHECK(same(value("sign(0.1)"), 1));
  CHECK(same(value("sign(-0)"), -0.0));
  CHECK(same(value("sign(flow)", {kNaN}), kNaN));
  CHECK(same(value("sign(flow)", {-kInfinity}), -1));
  CHECK(same(value("floor(-0.5)"), -1));
  CHECK(same(value("floor(-0)"), -0.0));
  CHECK(same(value("ceil(-0.5)"), -0.0));
  CHECK(same(value("ceil(2.1)"), 3));
  CHECK(same(value("round(0.5)"), 0));
  CHECK(same(value("round(1.5)"), 2));
  CHECK(same(value("round(2.5)"), 2));
  CHECK(same(value("round(-0.5)"), -0.0));
  CHECK(same(value("round(-2.5)"), -2));
  CHECK(same(value("round(0.49999999999999994)"), 0));
  CHECK(same(value("sqrt(2)"), 1.4142135623730951));
  CHECK(same(value("sqrt(-1)"), kNaN));
  CHECK(same(value("sqrt(-0)"), -0.0));
  CHECK(same(value("exp(0)"), 1));
  CHECK(same(value("exp(flow)", {-kInfinity}), 0));
  CHECK(same(value("exp(1000)"), kInfinity));
  CHECK(same(value("ln(1)"), 0));
  CHECK(same(value("ln(0)"), -kInfinity));
  CHECK(same(value("ln(-1)"), kNaN));
  CHECK(same(value("sin(0)"), 0));
  CHECK(same(value("cos(0)"), 1));
  CHECK(same(value("tan(-0)"), -0.0));
  CHECK(same(value("sin(flow)", {kInfinity}), kNaN));
  CHECK(same(value("asin(1)"), 1.5707963267948966));
  CHECK(same(value("asin(2)"), kNaN));
  CHECK(same(value("acos(1)"), 0));
  CHECK(same(value("atan(flow)", {kInfinity}), 1.5707963267948966));
}

TEST_CASE("Functions of the C library are called as they are") {
  volatile double x = 1.1;  // so that the compiler of this test folds nothing
  volatile double y = 2.0;
  CHECK(same(value("exp(1.1)"), std::exp(x)));
  CHECK(same(value("ln(1.1)"), std::log(x)));
  CHECK(same(value("sin(1.1)"), std::sin(x)));
  CHECK(same(value("cos(1.1)"), std::cos(x)));
  CHECK(same(value("tan(1.1)"), std::tan(x)));
  CHECK(same(value("atan(1.1)"), std::atan(x)));
  CHECK(same(value("pow(1.1, 2)"), std::pow(x, y)));
  CHECK(same(value("atan2(1.1, 2)"), std::atan2(x, y)));
}

TEST_CASE("pow, mod and atan2") {
  CHECK(same(value("pow(2, 10)"), 1024));
  CHECK(same(value("pow(flow, 0)", {kNaN}), 1));
  CHECK(same(value("pow(-8, 0.5)"), kNaN));
  CHECK(same(value("mod(7, 3)"), 1));
  CHECK(same(value("mod(-7, 3)"), -1));
  CHECK(same(value("mod(7, -3)"), 1));
  CHECK(same(value("mod(-6, 3)"), -0.0));
  CHECK(same(value("mod(5.5, 2)"), 1.5));
  CHECK(same(value("mod(1, 0)"), kNaN));
  CHECK(same(value("mod(1, flow)", {kInfinity}), 1));
  CHECK(same(value("atan2(1, 0)"), 1.5707963267948966));
  CHECK(same(value("atan2(0, -1)"), 3.141592653589793));
}

TEST_CASE("min and max take the first argument unless the second is less or greater") {
  CHECK(same(value("min(2, 1)"), 1));
  CHECK(same(value("min(1, 2)"), 1));
  CHECK(same(value("max(1, 2)"), 2));
  CHECK(same(value("max(3, 1, 4, 1, 5)"), 5));
  CHECK(same(value("min(0, -0)"), 0.0));
  CHECK(same(value("min(-0, 0)"), -0.0));
  CHECK(same(value("max(-0, 0)"), -0.0));
  CHECK(same(value("min(flow, 1)", {kNaN}), kNaN));
  CHECK(same(value("min(1, flow)", {kNaN}), 1));
  CHECK(same(value("max(flow, 1)", {kNaN}), kNaN));
  CHECK(same(value("max(1, flow)", {kNaN}), 1));
  CHECK(same(value("min(flow, 1, 0)", {kNaN}), kNaN));
}

TEST_CASE("wrap turns like an encoder, limit holds within bounds") {
  CHECK(same(value("wrap(370, 0, 360)"), 10));
  CHECK(same(value("wrap(-10, 0, 360)"), 350));
  CHECK(same(value("wrap(360, 0, 360)"), 0));
  CHECK(same(value("wrap(0, 0, 360)"), 0));
  CHECK(same(value("wrap(200, -180, 180)"), -160));
  CHECK(same(value("wrap(-180, -180, 180)"), -180));
  CHECK(same(value("wrap(1, 5, 5)"), kNaN));
  CHECK(same(value("limit(5, 0, 10)"), 5));
  CHECK(same(value("limit(-5, 0, 10)"), 0));
  CHECK(same(value("limit(50, 0, 10)"), 10));
  CHECK(same(value("limit(5, 10, 0)"), 0));
  CHECK(same(value("limit(flow, 0, 10)", {kNaN}), kNaN));
  CHECK(same(value("limit(flow, 0, 10)", {kInfinity}), 10));
}

TEST_CASE("A curve is level outside of its points and straight between them") {
  const std::string curve = "curve(flow, -1, 5, 0, 7, 2, 3, 10, 4)";
  CHECK(same(value(curve, {-kInfinity}), 5));
  CHECK(same(value(curve, {-2}), 5));
  CHECK(same(value(curve, {-1}), 5));
  CHECK(same(value(curve, {-0.5}), 6));
  CHECK(same(value(curve, {0}), 7));
  CHECK(same(value(curve, {1}), 5));
  CHECK(same(value(curve, {1.9999999999999998}), 7 + 1.9999999999999998 * -4 / 2));
  CHECK(same(value(curve, {2}), 3));
  CHECK(same(value(curve, {6}), 3.5));
  CHECK(same(value(curve, {10}), 4));
  CHECK(same(value(curve, {1000}), 4));
  CHECK(same(value(curve, {kInfinity}), 4));
  CHECK(same(value(curve, {kNaN}), kNaN));
  CHECK(same(value("curve(0.5, 0, 0, 1, 1) + curve(0.5, 0, 10, 1, 30)"), 20.5));
  // At a point the section that begins there counts: the one before gives 0.8999999999999999.
  CHECK(same(value("curve(3, 0.1, 0.1, 3, 0.9, 4, 2)"), 0.9));
  CHECK(same(value("curve(3, 0.1, 0.1, 3, 0.9)"), 0.9));
}

TEST_CASE("An operation takes the numbers that its name says") {
  using tables::FormulaOp;
  CHECK(tables::operands_of(FormulaOp::number) == 0);
  CHECK(tables::operands_of(FormulaOp::no) == 1);
  CHECK(tables::operands_of(FormulaOp::any) == 2);
  CHECK(tables::operands_of(FormulaOp::atan) == 1);
  CHECK(tables::operands_of(FormulaOp::max) == 2);
  CHECK(tables::operands_of(FormulaOp::choose) == 3);
  CHECK(tables::operands_of(FormulaOp::curve) == 1);
}

}  // namespace
}  // namespace symplant::test

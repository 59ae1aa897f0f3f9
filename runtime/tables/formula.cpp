// Works out formulas. Its options keep the compiler from fusing operations and from replacing calls of the C library.
#include "symplant/tables/formula.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace symplant::tables {
namespace {

constexpr std::size_t kOps = static_cast<std::size_t>(FormulaOp::curve) + 1;

/// How many numbers each operation takes.
constexpr std::array<std::uint8_t, kOps> kOperands = [] {
  std::array<std::uint8_t, kOps> operands{};
  const auto set = [&](FormulaOp first, FormulaOp last, std::uint8_t count) {
    for (auto op = static_cast<std::size_t>(first); op <= static_cast<std::size_t>(last); ++op) operands[op] = count;
  };
  set(FormulaOp::number, FormulaOp::input, 0);
  set(FormulaOp::negate, FormulaOp::no, 1);
  set(FormulaOp::add, FormulaOp::any, 2);
  set(FormulaOp::abs, FormulaOp::atan, 1);
  set(FormulaOp::pow, FormulaOp::max, 2);
  set(FormulaOp::wrap, FormulaOp::choose, 3);
  set(FormulaOp::curve, FormulaOp::curve, 1);
  return operands;
}();

double truth(bool is_true) noexcept { return is_true ? 1.0 : 0.0; }

/// NaN is true.
bool is_true(double x) noexcept { return x != 0; }

double of_one(FormulaOp op, double x) noexcept {
  switch (op) {
    case FormulaOp::negate:
      return -x;
    case FormulaOp::no:
      return truth(!is_true(x));
    case FormulaOp::abs:
      return std::fabs(x);
    case FormulaOp::sign:
      return formula_sign(x);
    case FormulaOp::floor:
      return std::floor(x);
    case FormulaOp::ceil:
      return std::ceil(x);
    case FormulaOp::round:
      return formula_round(x);
    case FormulaOp::sqrt:
      return std::sqrt(x);
    case FormulaOp::exp:
      return std::exp(x);
    case FormulaOp::ln:
      return std::log(x);
    case FormulaOp::sin:
      return std::sin(x);
    case FormulaOp::cos:
      return std::cos(x);
    case FormulaOp::tan:
      return std::tan(x);
    case FormulaOp::asin:
      return std::asin(x);
    case FormulaOp::acos:
      return std::acos(x);
    case FormulaOp::atan:
      return std::atan(x);
    default:
      return x;
  }
}

double of_two(FormulaOp op, double a, double b) noexcept {
  switch (op) {
    case FormulaOp::add:
      return a + b;
    case FormulaOp::subtract:
      return a - b;
    case FormulaOp::multiply:
      return a * b;
    case FormulaOp::divide:
      return a / b;
    case FormulaOp::less:
      return truth(a < b);
    case FormulaOp::less_equal:
      return truth(a <= b);
    case FormulaOp::equal:
      return truth(a == b);
    case FormulaOp::greater_equal:
      return truth(a >= b);
    case FormulaOp::greater:
      return truth(a > b);
    case FormulaOp::all:
      return truth(is_true(a) && is_true(b));
    case FormulaOp::any:
      return truth(is_true(a) || is_true(b));
    case FormulaOp::pow:
      return std::pow(a, b);
    case FormulaOp::mod:
      return std::fmod(a, b);
    case FormulaOp::atan2:
      return std::atan2(a, b);
    case FormulaOp::min:
      return formula_min(a, b);
    case FormulaOp::max:
      return formula_max(a, b);
    default:
      return a;
  }
}

double of_three(FormulaOp op, double a, double b, double c) noexcept {
  if (op == FormulaOp::choose) return is_true(a) ? b : c;
  return op == FormulaOp::wrap ? formula_wrap(a, b, c) : formula_limit(a, b, c);
}

/// The points of a curve: how many, then x and y of each.
std::span<const double> points_at(std::span<const double> numbers, std::uint32_t at) noexcept {
  return numbers.subspan(std::size_t{at} + 1, static_cast<std::size_t>(numbers[at]) * 2);
}

}  // namespace

std::uint32_t operands_of(FormulaOp op) noexcept { return kOperands[static_cast<std::size_t>(op)]; }

double evaluate(std::span<const FormulaStep> steps, std::span<const double> numbers, const double* inputs) noexcept {
  std::array<double, kMostFormulaDepth> stack;  // NOLINT(cppcoreguidelines-pro-type-member-init): written before read
  double* end = stack.data();
  for (const FormulaStep& step : steps) {
    switch (operands_of(step.op)) {
      case 0:
        *end++ = step.op == FormulaOp::input ? inputs[step.of] : step.number;
        break;
      case 1:
        end[-1] = step.op == FormulaOp::curve ? formula_curve(end[-1], points_at(numbers, step.of))
                                              : of_one(step.op, end[-1]);
        break;
      case 2:
        --end;
        end[-1] = of_two(step.op, end[-1], end[0]);
        break;
      default:
        end -= 2;
        end[-1] = of_three(step.op, end[-1], end[0], end[1]);
        break;
    }
  }
  return stack[0];
}

double formula_sign(double x) noexcept { return x > 0 ? 1.0 : x < 0 ? -1.0 : x; }

double formula_round(double x) noexcept { return std::nearbyint(x); }

double formula_min(double a, double b) noexcept { return b < a ? b : a; }

double formula_max(double a, double b) noexcept { return a < b ? b : a; }

double formula_wrap(double x, double low, double high) noexcept {
  return x - (high - low) * std::floor((x - low) / (high - low));
}

double formula_limit(double x, double low, double high) noexcept { return formula_min(formula_max(x, low), high); }

double formula_curve(double x, std::span<const double> points) noexcept {
  if (std::isnan(x)) return x;
  if (x <= points[0]) return points[1];
  std::size_t below = 0;  // the last point with x at or below
  std::size_t above = points.size() / 2;
  while (above - below > 1) {
    const std::size_t middle = below + (above - below) / 2;
    (points[middle * 2] <= x ? below : above) = middle;
  }
  if (above * 2 == points.size()) return points[below * 2 + 1];
  const double x0 = points[below * 2];
  const double y0 = points[below * 2 + 1];
  return y0 + (x - x0) * (points[above * 2 + 1] - y0) / (points[above * 2] - x0);
}

}  // namespace symplant::tables

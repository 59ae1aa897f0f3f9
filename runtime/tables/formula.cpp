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

using formula::truth;

/// NaN is true.
bool is_true(double x) noexcept { return x != 0; }

double of_one(FormulaOp op, double x) noexcept {
  switch (op) {
    case FormulaOp::negate:
      return -x;
    case FormulaOp::no:
      return truth(!is_true(x));
    case FormulaOp::abs:
      return formula::abs(x);
    case FormulaOp::sign:
      return formula::sign(x);
    case FormulaOp::floor:
      return formula::floor(x);
    case FormulaOp::ceil:
      return formula::ceil(x);
    case FormulaOp::round:
      return formula::round(x);
    case FormulaOp::sqrt:
      return formula::sqrt(x);
    case FormulaOp::exp:
      return formula::exp(x);
    case FormulaOp::ln:
      return formula::ln(x);
    case FormulaOp::sin:
      return formula::sin(x);
    case FormulaOp::cos:
      return formula::cos(x);
    case FormulaOp::tan:
      return formula::tan(x);
    case FormulaOp::asin:
      return formula::asin(x);
    case FormulaOp::acos:
      return formula::acos(x);
    case FormulaOp::atan:
      return formula::atan(x);
    default:
      return x;
  }
}

double of_two(FormulaOp op, double a, double b) noexcept {
  switch (op) {
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
      return formula::pow(a, b);
    case FormulaOp::mod:
      return formula::mod(a, b);
    case FormulaOp::atan2:
      return formula::atan2(a, b);
    case FormulaOp::min:
      return formula::min(a, b);
    case FormulaOp::max:
      return formula::max(a, b);
    default:
      return a;
  }
}

double of_three(FormulaOp op, double a, double b, double c) noexcept {
  if (op == FormulaOp::choose) return is_true(a) ? b : c;
  return op == FormulaOp::wrap ? formula::wrap(a, b, c) : formula::limit(a, b, c);
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
    switch (step.op) {  // the most frequent ones
      case FormulaOp::number:
        *end++ = step.number;
        continue;
      case FormulaOp::input:
        *end++ = inputs[step.of];
        continue;
      case FormulaOp::add:
        --end;
        end[-1] = end[-1] + end[0];
        continue;
      case FormulaOp::subtract:
        --end;
        end[-1] = end[-1] - end[0];
        continue;
      case FormulaOp::multiply:
        --end;
        end[-1] = end[-1] * end[0];
        continue;
      case FormulaOp::curve:
        end[-1] = formula::curve(end[-1], points_at(numbers, step.of));
        continue;
      default:
        break;
    }
    switch (operands_of(step.op)) {
      case 1:
        end[-1] = of_one(step.op, end[-1]);
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

}  // namespace symplant::tables

namespace symplant::tables::formula {

double exp(double x) noexcept { return std::exp(x); }
double ln(double x) noexcept { return std::log(x); }
double sin(double x) noexcept { return std::sin(x); }
double cos(double x) noexcept { return std::cos(x); }
double tan(double x) noexcept { return std::tan(x); }
double asin(double x) noexcept { return std::asin(x); }
double acos(double x) noexcept { return std::acos(x); }
double atan(double x) noexcept { return std::atan(x); }
double pow(double x, double y) noexcept { return std::pow(x, y); }
double mod(double x, double y) noexcept { return std::fmod(x, y); }
double atan2(double y, double x) noexcept { return std::atan2(y, x); }

double wrap(double x, double low, double high) noexcept {
  return x - (high - low) * std::floor((x - low) / (high - low));
}

double curve(double x, std::span<const double> points) noexcept {
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

}  // namespace symplant::tables::formula

// What the number of a signal says about the value that it shows.
#include "study/shown.hpp"

#include <cmath>
#include <vector>

namespace symplant::study {
namespace {

using Op = tables::FormulaOp;

/// A number on the stack of a formula: factor * x + offset, where x is the only input.
struct Term {
  double factor = 0;
  double offset = 0;

  bool is_number() const { return factor == 0; }
};

/// The result of an operation of one number; nothing if it makes no line.
std::optional<Term> made(Op op, const Term& x) {
  switch (op) {
    case Op::negate:
      return Term{-x.factor, -x.offset};
    case Op::floor:
      return x.is_number() ? Term{0, std::floor(x.offset)} : Term{x.factor, x.offset - 0.5};
    case Op::ceil:
      return x.is_number() ? Term{0, std::ceil(x.offset)} : Term{x.factor, x.offset + 0.5};
    case Op::round:
      return x.is_number() ? Term{0, std::nearbyint(x.offset)} : x;
    default:
      return std::nullopt;
  }
}

/// The same of two numbers.
std::optional<Term> made(Op op, const Term& x, const Term& y) {
  switch (op) {
    case Op::add:
      return Term{x.factor + y.factor, x.offset + y.offset};
    case Op::subtract:
      return Term{x.factor - y.factor, x.offset - y.offset};
    case Op::multiply:
      if (x.is_number()) return Term{x.offset * y.factor, x.offset * y.offset};
      if (y.is_number()) return Term{x.factor * y.offset, x.offset * y.offset};
      return std::nullopt;
    case Op::divide:
      if (y.is_number() && y.offset != 0) return Term{x.factor / y.offset, x.offset / y.offset};
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

/// Takes the operands of a step from the stack, and pushes what it makes; false if that is no line.
bool apply(const tables::FormulaStep& step, std::vector<Term>& stack) {
  std::optional<Term> result;
  if (step.op == Op::number) {
    result = Term{0, step.number};
  } else if (step.op == Op::input) {
    result = Term{1, 0};
  } else if (step.op == Op::wrap) {
    if (!stack[stack.size() - 3].is_number()) result = stack[stack.size() - 3];
    stack.resize(stack.size() - 3);
  } else if (step.op == Op::add || step.op == Op::subtract || step.op == Op::multiply || step.op == Op::divide) {
    result = made(step.op, stack[stack.size() - 2], stack.back());
    stack.resize(stack.size() - 2);
  } else if (step.op == Op::negate || step.op == Op::floor || step.op == Op::ceil || step.op == Op::round) {
    result = made(step.op, stack.back());
    stack.pop_back();
  }
  if (result) stack.push_back(*result);
  return result.has_value();
}

}  // namespace

std::optional<Line> line_of(const condition::Formula& formula) {
  if (formula.inputs.size() != 1 || formula.inputs.front().kind != condition::FormulaInput::Kind::output) {
    return std::nullopt;
  }
  std::vector<Term> stack;
  for (const tables::FormulaStep& step : formula.steps) {
    if (!apply(step, stack)) return std::nullopt;
  }
  const Term& result = stack.back();
  if (result.factor == 0 || !std::isfinite(result.factor) || !std::isfinite(result.offset)) return std::nullopt;
  return Line{formula.inputs.front().of, result.factor, result.offset};
}

std::optional<Line> line_of(const model::Signal& signal) {
  std::optional<Line> line = line_of(signal.formula);
  if (!line || !signal.row.scaled) return line;
  const tables::SignalRow& row = signal.row;
  const double scale = (row.d - row.c) / (row.b - row.a);
  if (scale == 0) return std::nullopt;
  return Line{line->output, line->factor * scale, row.c + (line->offset - row.a) * scale};
}

double period_of(const model::Signal& signal) {
  const auto& steps = signal.formula.steps;
  if (steps.size() < 4 || steps.back().op != Op::wrap) return 0;
  const tables::FormulaStep& low = steps[steps.size() - 3];
  const tables::FormulaStep& high = steps[steps.size() - 2];
  if (low.op != Op::number || high.op != Op::number) return 0;
  const tables::SignalRow& row = signal.row;
  return std::abs((high.number - low.number) * (row.scaled ? (row.d - row.c) / (row.b - row.a) : 1));
}

}  // namespace symplant::study

// The tables of values and signals: numbers that change with time by formulas (docs/values.md).
//
// A value has one output, or several if it is `linear`; outputs are numbered in the order of their values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "symplant/tables/material.hpp"
#include "symplant/tables/number.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::tables {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum class ValueKind : std::uint8_t {
  parameter,
  integral,    ///< x + h * u
  lag,         ///< PT1: x + (u - x) * factor
  ramp,        ///< toward u, at most `up` and `down` a second
  delay,       ///< u, some steps later
  derivative,  ///< (u - last u) / h
  is,          ///< u
  position,    ///< of a unit that moves between states with numbers
  noise,       ///< normally distributed
  pid,
  linear,  ///< a discrete state-space model
};

/// The keys of plant.json, by ValueKind; a parameter has none there.
inline constexpr std::array<std::string_view, 11> kValueKindNames{
    "parameter", "integral", "lag", "ramp", "delay", "derivative", "is", "position", "noise", "pid", "linear"};
static_assert(static_cast<std::size_t>(ValueKind::linear) + 1 == kValueKindNames.size());

constexpr std::string_view value_kind_name(ValueKind kind) noexcept {
  return kValueKindNames[static_cast<std::size_t>(kind)];
}

/// Whether the output stays until a step or a jump changes it: such a value has a start, may jump and may be set.
constexpr bool keeps_its_output(ValueKind kind) noexcept {
  return kind == ValueKind::parameter || kind == ValueKind::integral || kind == ValueKind::lag ||
         kind == ValueKind::ramp;
}

/// Whether it stores the results of its formulas, and makes its next step from them.
constexpr bool makes_steps(ValueKind kind) noexcept {
  return kind == ValueKind::integral || kind == ValueKind::lag || kind == ValueKind::ramp || kind == ValueKind::delay ||
         kind == ValueKind::linear;
}

/// Whether its outputs are worked out at each computation, in ValueTables::order.
constexpr bool is_computed(ValueKind kind) noexcept { return !keeps_its_output(kind) && kind != ValueKind::delay; }

/// What a step of a formula does with the numbers on its stack: a formula is in postfix form. Comparisons, `all`, `any`
/// and `no` give 0 or 1.
enum class FormulaOp : std::uint8_t {
  number,  ///< pushes FormulaStep::number
  input,   ///< pushes the input `of` of the formula
  negate,
  no,
  add,
  subtract,
  multiply,
  divide,
  less,
  less_equal,
  equal,
  greater_equal,
  greater,
  all,
  any,
  abs,
  sign,
  floor,
  ceil,
  round,
  sqrt,
  exp,
  ln,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  pow,
  mod,
  atan2,
  min,
  max,
  wrap,    ///< x, low, high
  limit,   ///< x, low, high
  choose,  ///< condition, then, else
  curve,   ///< of x; the points are at `of` in ValueTables::numbers: how many, then x and y of each
};

struct FormulaStep {
  FormulaOp op{};
  std::uint32_t of = 0;
  double number = 0;
};

enum class FormulaInputKind : std::uint8_t {
  output,           ///< of a value: `of` is its output
  truth,            ///< 0 or 1: a condition whose reader is this input sets it; `of` is not used
  operation_value,  ///< a numeric symbol: `of` is its slot
  event_value,
  parts,   ///< `of` is a PartCounterRow
  weight,  ///< `of` is a location: the sum of the weights of its parts
  time,    ///< plant time in seconds
};

struct FormulaInput {
  FormulaInputKind kind{};
  NumberKind number{};  ///< of a numeric symbol
  std::uint32_t of = 0;
};

inline constexpr std::uint32_t kMostFormulaDepth = 64;  ///< numbers on the stack of a formula

struct FormulaRow {
  Rows steps;
  Rows inputs;
};

/// A formula as compiled code.
struct CompiledFormula {
  /// Input i of FormulaRow::inputs is numbers[slots[i]].
  double (*call)(const double* numbers, const std::uint32_t* slots) noexcept = nullptr;
  bool replaced = false;  ///< it is the user's and not what the description says
};

/// Jumps of a value: when the condition begins to hold, the output becomes the result of the formula.
struct ChangeRow {
  std::uint32_t condition = 0;
  std::uint32_t formula = 0;
};

struct ValueRow {
  ValueKind kind{};
  double start = 0;
  double min = 0;              ///< -infinity: none
  double max = 0;              ///< infinity: none
  Time step = 0;               ///< 0: a parameter
  Time trace = 0;              ///< 0: never in a trace
  std::uint32_t output = 0;    ///< its first one
  std::uint32_t formula = 0;   ///< its first one: u; `ramp`: u, up, down; `pid`: of, to; `linear`: each u
  std::uint32_t formulas = 0;  ///< how many
  double factor = 0;           ///< `lag`: 1 - exp(-h / T); `noise`: the standard deviation; `pid`: kp
  double ti = 0;               ///< `pid`, in seconds; 0: none
  double td = 0;               ///< `pid`, in seconds
  std::uint32_t steps = 0;     ///< `delay`: time / step
  std::uint32_t unit = 0;      ///< `position`
  std::uint32_t numbers = 0;   ///< `position`: of each state; `linear`: x at the start, a, b, c, d, row by row
  std::uint32_t states = 0;    ///< `linear`
  std::uint32_t outputs = 1;   ///< `linear`: more than one is possible
  bool direct = false;         ///< `linear`: it has d
  Rows changes;

  /// Its outputs before the first computation, within its limits and never -0.
  constexpr double start_output() const noexcept {
    const double from = kind == ValueKind::linear ? 0 : start;
    return (from < min ? min : from > max ? max : from) + 0.0;
  }
};

inline constexpr std::size_t kMostLinear = 16;  ///< states, inputs and outputs of a `linear` value, each

/// Writes a formula to a numeric event.
struct SignalRow {
  std::uint32_t symbol = 0;
  std::uint32_t formula = 0;
  Time every = 0;
  bool scaled = false;  ///< c + (u - a) * (d - c) / (b - a)
  double a = 0;
  double b = 0;
  double c = 0;
  double d = 0;
  double noise = 0;  ///< the standard deviation
  double low = 0;    ///< -infinity: the type's
  double high = 0;   ///< infinity: the type's
};

/// An operand of a comparison.
struct Operand {
  enum class Kind : std::uint8_t { number, output, operation_value, event_value, parts, weight };
  Kind kind{};
  NumberKind type{};     ///< of a numeric symbol
  std::uint32_t of = 0;  ///< as FormulaInput::of
  double number = 0;
};

/// Input `input` of `condition` is the comparison of two operands; `equal` holds within the tolerance, at its ends too.
struct ComparisonRow {
  Operand left;
  Operand right;
  double tolerance = 0;
  std::uint32_t condition = 0;
  std::uint8_t input = 0;
  Comparison comparison{};
};

/// Empty in a plant without values, signals, comparisons of two operands and times by formulas.
struct ValueTables {
  std::span<const ValueRow> rows;
  std::span<const std::uint32_t> order;  ///< of the values that are computed from others, each after those it reads
  std::span<const ChangeRow> changes;
  std::span<const SignalRow> signals;
  std::span<const FormulaRow> formulas;
  std::span<const FormulaStep> steps;
  std::span<const CompiledFormula> compiled;  ///< by formula; empty: the steps are worked out
  std::span<const FormulaInput> inputs;
  std::span<const double> numbers;
  std::span<const ComparisonRow> comparisons;
  std::uint32_t outputs = 0;
  std::string_view names;          ///< a value: its name, then its unit
  std::string_view formula_texts;  ///< a formula: as the description has it

  bool empty() const noexcept { return rows.empty() && formulas.empty() && comparisons.empty(); }
};

}  // namespace symplant::tables

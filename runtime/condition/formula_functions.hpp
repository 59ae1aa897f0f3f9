// The functions of formulas, by name.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "symplant/tables/value.hpp"

namespace symplant::condition {

struct FormulaFunction {
  std::string_view name;
  tables::FormulaOp op;
  std::string_view arguments;  ///< for messages
  std::uint32_t count;         ///< of arguments; `min`, `max` and `curve` take more, too
};

inline constexpr std::array<FormulaFunction, 23> kFormulaFunctions{{
    {"abs", tables::FormulaOp::abs, "x", 1},
    {"sign", tables::FormulaOp::sign, "x", 1},
    {"floor", tables::FormulaOp::floor, "x", 1},
    {"ceil", tables::FormulaOp::ceil, "x", 1},
    {"round", tables::FormulaOp::round, "x", 1},
    {"sqrt", tables::FormulaOp::sqrt, "x", 1},
    {"exp", tables::FormulaOp::exp, "x", 1},
    {"ln", tables::FormulaOp::ln, "x", 1},
    {"sin", tables::FormulaOp::sin, "x", 1},
    {"cos", tables::FormulaOp::cos, "x", 1},
    {"tan", tables::FormulaOp::tan, "x", 1},
    {"asin", tables::FormulaOp::asin, "x", 1},
    {"acos", tables::FormulaOp::acos, "x", 1},
    {"atan", tables::FormulaOp::atan, "x", 1},
    {"pow", tables::FormulaOp::pow, "x, y", 2},
    {"mod", tables::FormulaOp::mod, "x, y", 2},
    {"atan2", tables::FormulaOp::atan2, "y, x", 2},
    {"min", tables::FormulaOp::min, "a, b", 2},
    {"max", tables::FormulaOp::max, "a, b", 2},
    {"wrap", tables::FormulaOp::wrap, "x, low, high", 3},
    {"limit", tables::FormulaOp::limit, "x, low, high", 3},
    {"if", tables::FormulaOp::choose, "condition, then, else", 3},
    {"curve", tables::FormulaOp::curve, "x, x0, y0, x1, y1", 5},
}};

}  // namespace symplant::condition

// Formulas as C++ functions.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emit/row_writer.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

/// The name of a value or of what a formula reads, as C++ has it: `tank_level` for TANK.level, `boom_2` for BOOM[2].
/// Not yet an identifier.
std::string function_name(std::string_view name);

/// A formula as C++: `2.0 * pump_run - 0.05 * level`, with `inputs` as the names of its inputs and the points of curves
/// in `numbers`. It does the same operations in the same order as tables::evaluate(). O(steps).
std::string formula_expression(std::span<const tables::FormulaStep> steps, std::span<const double> numbers,
                               const std::vector<std::string>& inputs);

/// The functions of all formulas in the order of the tables, each with its value, unit and text above.
std::string formula_function_rows(const lower::EngineTables& tables, const model::PlantModel& plant);

/// Their entries in the table of functions, in the same order.
std::string formula_entry_rows(const lower::EngineTables& tables, const model::PlantModel& plant);

}  // namespace symplant::emit

// Tables of the engine as C++ initializers: one row per line, with a comment that names its subject.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "emit/row_writer.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

// Every function writes or returns all rows of a table, without a line end after the last; nothing for an empty table.
// O(rows).
void unit_rows(RowWriter& rows, const lower::EngineTables& tables);
std::string time_rows(const lower::EngineTables& tables);
std::string random_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
/// A constant for each kind of symbol in the plant.
std::string kind_rows(const lower::EngineTables& tables);
void symbol_rows(RowWriter& rows, const lower::EngineTables& tables, const model::PlantModel& plant);
std::string list_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
void initial_rows(RowWriter& rows, const lower::EngineTables& tables, const model::PlantModel& plant);
std::string shared_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string disable_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
/// `classes` are the names of the types. A type with a custom behavior has the row of the user's class.
std::string type_rows(const lower::EngineTables& tables, const model::PlantModel& plant,
                      const std::vector<std::string>& classes, const std::string& name_space);

/// The enumerators of tables::DataType and tables::Direction.
std::string_view data_type_name(tables::DataType type);
std::string_view direction_name(tables::Direction direction);

/// The texts of a blob as string literals, `per_line` on each line. The blob must not be empty.
void name_rows(RowWriter& rows, const std::string& blob, int per_line);

/// An enumerator for each symbol.
void symbol_constant_rows(RowWriter& rows, const lower::EngineTables& tables);

}  // namespace symplant::emit

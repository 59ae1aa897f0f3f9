// The one writer of rows: tables as C++ initialisers, a row a line, each citing what it is.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "emit/row_writer.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

// Every function writes all rows, or gives them without a line end behind the last; nothing where a table has none.
// O(rows).
void unit_rows(RowWriter& rows, const lower::EngineTables& tables);
std::string time_rows(const lower::EngineTables& tables);
std::string random_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
/// A constant for each kind of symbol that the plant has.
std::string kind_rows(const lower::EngineTables& tables);
void symbol_rows(RowWriter& rows, const lower::EngineTables& tables, const model::PlantModel& plant);
std::string list_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
void initial_rows(RowWriter& rows, const lower::EngineTables& tables, const model::PlantModel& plant);
std::string shared_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string disable_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string type_rows(const std::vector<std::string>& classes, const std::string& name_space);
std::string transition_rows(const lower::Type& type, const model::Unit& example, const model::PlantModel& plant);

/// The enumerators of tables::DataType and tables::Direction.
std::string_view data_type_name(tables::DataType type);
std::string_view direction_name(tables::Direction direction);

/// A blob's texts, of which there must be one, as string literals, `per_line` on each line.
void name_rows(RowWriter& rows, const std::string& blob, int per_line);

void device_rows(RowWriter& rows, const lower::EngineTables& tables);
void symbol_constant_rows(RowWriter& rows, const lower::EngineTables& tables);

}  // namespace symplant::emit

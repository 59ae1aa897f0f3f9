// The plant's tables for tables_gen.cpp: the tables that have rows, and the members of the plant's tables.
#pragma once

#include "emit/render.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

/// Adds the lists `row_tables`, `text_tables` and `members` to a view. O(rows).
void add_tables(View& view, const lower::EngineTables& tables, const model::PlantModel& plant);

}  // namespace symplant::emit

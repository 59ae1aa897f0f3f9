// Functions of the plant class that give its devices by line, process and name.
#pragma once

#include <string>
#include <vector>

#include "emit/row_writer.hpp"
#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

/// The rows of these functions. Their names depend on the names and types of the devices, not on the order of rows.
struct Accessors {
  RowSource groups;  ///< a class for each line and each process
  RowSource plant;   ///< for the plant class: lines, and the processes and devices whose names are unique
};

/// `classes` are the names of the types, `name_space` that of the plant. The sources may be read as long as tables and
/// model exist. O(devices * log devices).
Accessors accessors(const lower::EngineTables& tables, const model::PlantModel& plant,
                    const std::vector<std::string>& classes, const std::string& name_space);

}  // namespace symplant::emit

// Rows of the material flow.
#pragma once

#include <string>

#include "lower/engine_tables.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

// Every function returns all rows of a table, without a line end after the last; nothing for an empty table. O(rows).
std::string part_kind_rows(const model::Material& material);
std::string track_rows(const lower::EngineTables& tables, const model::Material& material);
std::string drive_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string stop_rows(const lower::EngineTables& tables, const model::Material& material);
std::string end_rows(const lower::EngineTables& tables, const model::Material& material);
std::string part_sensor_rows(const lower::EngineTables& tables, const model::PlantModel& plant);
std::string place_rows(const lower::EngineTables& tables, const model::Material& material);
std::string transfer_rows(const lower::EngineTables& tables, const model::Material& material);
std::string work_rows(const lower::EngineTables& tables, const model::Material& material);
std::string source_rows(const lower::EngineTables& tables, const model::Material& material);
/// `kinds`: EngineTables::material.sensor_kinds or source_kinds.
std::string kind_number_rows(const std::vector<std::uint32_t>& kinds, const model::Material& material);
std::string part_counter_rows(const lower::EngineTables& tables, const model::Material& material);
std::string part_watch_rows(const lower::EngineTables& tables);

/// Enumerators of the tracks and then of the places, and of the kinds.
std::string location_constant_rows(const model::Material& material);
std::string part_kind_constant_rows(const model::Material& material);

}  // namespace symplant::emit

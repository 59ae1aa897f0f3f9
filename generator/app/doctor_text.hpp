// The doctor's report for people and as JSON.
#pragma once

#include <string>

#include "symplant/link/doctor/report.hpp"
#include "symplant/tables/tables.hpp"

namespace symplant::app {

/// The steps, then the points with findings; with `all`, all points.
std::string doctor_text(const link::doctor::Report& report, const tables::PlantTables& tables, bool all);

/// `{"symplant-doctor":1,...}` with every step and point.
std::string doctor_json(const link::doctor::Report& report, const tables::PlantTables& tables);

/// Whether a step or a point is not good; skipped ones do not count.
bool has_findings(const link::doctor::Report& report);

}  // namespace symplant::app

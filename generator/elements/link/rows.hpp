// The plant's links and programs as rows of generated code.
#pragma once

#include <string>
#include <vector>

#include "model/layout.hpp"
#include "model/plant_model.hpp"

namespace symplant::emit {

/// The links of the description: controller, URL.
std::string link_rows(const description::Description& description);

/// The programs of the description, and the arrays of their `ignore`: kIgnoredVariables0 of the first program.
std::string program_rows(const description::Description& description);
std::string ignored_variables(const description::Description& description);

/// The entries of `ignore` for findings of a run, and their rows: name, pattern, last day.
std::vector<const description::GivenCheck::Ignore*> ignored_findings(const description::Description& description);
std::string ignored_rows(const description::Description& description);

/// The layout of the panel: station and place of each device, and the names of the stations.
std::string device_view_rows(const model::Layout& layout);
std::string station_rows(const model::Layout& layout);
/// The comment of each symbol, and whether a person operates it; empty if there are neither.
std::string symbol_view_rows(const model::PlantModel& plant);
/// `alarms`: at least one, by output.
std::string alarm_view_rows(const std::vector<model::Alarm>& alarms, const model::PlantModel& plant);

/// The arrays that the settings point to: links::kLinkRows0 and links::kKeep0 for controller 0.
std::string place_arrays(const model::PlantModel& plant);

/// The settings, one row for each controller. A row omits members that are equal to the defaults of link::LinkSettings.
std::string link_settings_rows(const model::PlantModel& plant);

}  // namespace symplant::emit

// Reads the scenario of a run from its file.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "symplant/scenario/scenario.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::host {

/// The scenario; nothing, with every error and its location on `err`, if it cannot be read.
std::optional<scenario::Scenario> load_scenario(const std::string& path, const trace::PlantNames& names,
                                                const std::vector<bool>& carried, std::ostream& err);

/// `scenario s.json: 7 steps, 3 with expectations`.
std::string scenario_summary(const std::string& path, const scenario::Scenario& scenario);

}  // namespace symplant::host

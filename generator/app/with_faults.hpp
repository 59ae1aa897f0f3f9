// A plant with the malfunctions of campaigns.
#pragma once

#include <string>
#include <vector>

#include "app/pipeline.hpp"

namespace symplant::app {

/// Adds the malfunctions that campaigns need to a compiled plant, and lowers it again. Returns the names among these
/// that the plant has already. O(symbols).
std::vector<std::string> add_fault_malfunctions(Compiled& compiled);

/// Whether a trace is of the plant with these malfunctions, and not of the plant without them. O(symbols).
bool is_of_fault_run(const std::string& trace, const Compiled& compiled);

}  // namespace symplant::app

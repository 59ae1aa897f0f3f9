// Cases that once showed a difference, kept as folders of files.
#pragma once

#include <string>

#include "property/files/tool_run.hpp"

namespace symplant::property::files {

/// list.csv, plant.json, scenario.json, run.txt (seed and end), and the expected results.
void write_fixture(const std::string& folder, const Files& files, const Outcome& wanted, const std::string& about);

/// Runs every folder in `folder`, or `folder` itself. Prints each difference to std::cout; returns the exit code.
int replay_fixtures(const std::string& folder);

}  // namespace symplant::property::files

// Cases that once showed a disagreement, kept as folders of files.
#pragma once

#include <string>

#include "property/files/tool_run.hpp"

namespace symplant::property::files {

/// list.csv, plant.json, scenario.json, run.txt (seed and end), and what is to come of them.
void write_fixture(const std::string& folder, const Files& files, const Outcome& wanted, const std::string& about);

/// Runs every folder in `folder`, or that folder itself. Says on std::cout what is not as it was; gives the exit code.
int replay_fixtures(const std::string& folder);

}  // namespace symplant::property::files

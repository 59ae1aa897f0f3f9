// That no file which a run writes is one that it reads, or another one that it writes.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "symplant/host/run_options.hpp"

namespace symplant::host {

/// False, and told on `err`, where an output would destroy an input or another output. `inputs` are those of the plant.
bool files_are_apart(const RunOptions& options, const std::vector<std::string>& inputs, std::ostream& err);

/// Whether a path means standard output.
bool is_standard_output(const std::string& path);

/// Whether an output goes to standard output, so that nothing else may.
bool uses_standard_output(const RunOptions& options);

}  // namespace symplant::host

// Checks that no output file of a run is also an input or another output.
#pragma once

#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "symplant/host/run_options.hpp"

namespace symplant::host {

/// False, with messages on `err`, if an output would overwrite an input or another output. `inputs`: files of the
/// plant.
bool files_are_apart(const RunOptions& options, std::span<const std::string_view> inputs, std::ostream& err);

/// Whether a path means standard output.
bool is_standard_output(const std::string& path);

/// Whether an output file goes to standard output, which then must have no other output.
bool uses_standard_output(const RunOptions& options);

}  // namespace symplant::host

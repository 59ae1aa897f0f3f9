// The property test of files as a function.
#pragma once

#include "property/options.hpp"

namespace symplant::property::files {

/// Does what `property_files` does: returns its exit code.
int run_files(const Options& options);

}  // namespace symplant::property::files

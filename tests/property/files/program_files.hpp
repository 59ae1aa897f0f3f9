// The property test from files as a function.
#pragma once

#include "property/options.hpp"

namespace symplant::property::files {

/// What `property_files` does: gives its exit code.
int run_files(const Options& options);

}  // namespace symplant::property::files

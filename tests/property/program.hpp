// The property test's program, for its main and for those of the planted bugs.
#pragma once

#include <string>
#include <vector>

namespace symplant::property {

/// Returns 0 if all is as requested (options.hpp), 1 if not, 2 if an argument is invalid.
int run_program(const std::vector<std::string>& arguments);

}  // namespace symplant::property

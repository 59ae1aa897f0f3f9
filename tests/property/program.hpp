// The property test's program, for its own main and for those of the planted bugs.
#pragma once

#include <string>
#include <vector>

namespace symplant::property {

/// 0 where all is as asked (options.hpp), 1 where it is not, 2 where an argument is not understood.
int run_program(const std::vector<std::string>& arguments);

}  // namespace symplant::property

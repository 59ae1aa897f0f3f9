// Dependency files, as make and ninja read them.
#pragma once

#include <string>
#include <vector>

namespace symplant::app {

/// `target: input input ...`, with spaces and other special characters escaped.
std::string depfile(const std::string& target, const std::vector<std::string>& inputs);

}  // namespace symplant::app

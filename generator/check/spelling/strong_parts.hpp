// The parts of a directed graph whose members all lead to each other.
#pragma once

#include <cstdint>
#include <vector>

namespace symplant::check {

/// Strongly connected parts (Tarjan), each ascending, by their first member. `edges[i]` are the nodes that i leads to.
/// O(nodes + edges), no recursion.
std::vector<std::vector<std::uint32_t>> strong_parts(const std::vector<std::vector<std::uint32_t>>& edges);

}  // namespace symplant::check

// Proposes a naming rule for symbol lists.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "infer/evaluate.hpp"
#include "name/naming.hpp"

namespace symplant::infer {

struct Proposal {
  name::Naming naming;
  name::Counts score;              ///< on all samples
  std::vector<std::string> steps;  ///< what was found and why, for --verbose
};

/// Deterministic. `known` are rules that the result must not fall below. Looks at some thousand samples in search of
/// rules, then applies them to all. O(samples).
Proposal infer(std::span<const Sample> samples, std::span<const name::Naming> known);

}  // namespace symplant::infer

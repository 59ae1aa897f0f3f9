// Chooses the candidates that pair most together.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "infer/candidates.hpp"
#include "infer/evaluate.hpp"

namespace symplant::infer {

/// The rules chosen, in the order in which they apply.
struct Choice {
  std::vector<name::SymbolRule> rules;
  Score score;
  std::vector<std::string> steps;  ///< what was chosen and why, for --verbose
};

/// `frame` is a naming rule without rules. Adds the candidate that pairs most, again and again, until none pairs more.
/// O(samples * candidates * rounds).
Choice choose(const name::Naming& frame, const std::vector<Candidate>& candidates, std::span<const Sample> samples);

}  // namespace symplant::infer

// Proposes a naming rule for symbol lists.
#pragma once

#include <cstddef>
#include <cstdint>
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

/// Whether interlocks with one text on both sides are set apart, or paired as any other text.
enum class Interlocks : std::uint8_t { apart, paired };

/// Deterministic. The result is not worse than any rule in `known`. Searches for rules in some thousand samples, then
/// applies them to all. O(samples).
Proposal infer(std::span<const Sample> samples, std::span<const name::Naming> known,
               Interlocks interlocks = Interlocks::apart);

}  // namespace symplant::infer

// The order in which a person reads findings.
#pragma once

#include <span>
#include <vector>

#include "diag/diagnostic.hpp"

namespace symplant::diag {

/// The most severe first; of these the rules of rows and addresses, which hold for every naming rule; of these what
/// concerns the most symbols. Others keep their order. O(findings * log(findings)).
std::vector<const Diagnostic*> by_importance(std::span<const Diagnostic> findings);

}  // namespace symplant::diag

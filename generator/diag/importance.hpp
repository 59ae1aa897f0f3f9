// The order in which a person reads findings.
#pragma once

#include <span>
#include <vector>

#include "diag/diagnostic.hpp"

namespace symplant::diag {

/// The most severe findings first; among these, findings of rows and addresses, which hold for every naming rule; among
/// these, findings that concern the most symbols. Otherwise the order is kept. O(findings * log(findings)).
std::vector<const Diagnostic*> by_importance(std::span<const Diagnostic> findings);

}  // namespace symplant::diag

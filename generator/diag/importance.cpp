// Sorts findings.
#include "diag/importance.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace symplant::diag {

std::vector<const Diagnostic*> by_importance(std::span<const Diagnostic> findings) {
  std::vector<const Diagnostic*> sorted;
  sorted.reserve(findings.size());
  for (const Diagnostic& finding : findings) sorted.push_back(&finding);
  const auto key = [](const Diagnostic& finding) {
    const char group = finding.rule->id.size() > 2 ? finding.rule->id[2] : ' ';
    return std::tuple(-static_cast<int>(finding.severity), group != '1' && group != '3',
                      -static_cast<std::ptrdiff_t>(finding.count + finding.shown_consequences));
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const Diagnostic* a, const Diagnostic* b) { return key(*a) < key(*b); });
  return sorted;
}

}  // namespace symplant::diag

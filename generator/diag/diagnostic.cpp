// Rules and what they found.
#include "diag/diagnostic.hpp"

#include <algorithm>
#include <utility>

namespace symplant::diag {

std::string_view severity_name(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return {};
}

void Diagnostics::add(const RuleInfo& rule, std::string message, Place place, std::vector<Related> related) {
  ++counts_[static_cast<std::size_t>(rule.severity)];
  all_.push_back({&rule, std::move(message), std::move(place), std::move(related)});
}

void Diagnostics::sort_by_place() {
  std::stable_sort(all_.begin(), all_.end(), [](const Diagnostic& a, const Diagnostic& b) {
    const std::size_t first = a.place.source ? a.place.span.begin : 0;
    const std::size_t second = b.place.source ? b.place.span.begin : 0;
    return first < second;
  });
}

}  // namespace symplant::diag

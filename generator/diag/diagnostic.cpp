// Rules and what they found.
#include "diag/diagnostic.hpp"

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

}  // namespace symplant::diag

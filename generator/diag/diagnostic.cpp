// Rules and what they found.
#include "diag/diagnostic.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
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

void Diagnostics::sort_by_place(std::span<const base::SourceFile* const> files) {
  const std::unordered_set<const base::SourceFile*> given(files.begin(), files.end());
  std::unordered_map<const base::SourceFile*, std::size_t> ranks;  // looked up only, so that no pointer's value shows
  for (const Diagnostic& diagnostic : all_) {
    const base::SourceFile* const file = diagnostic.place.source.get();
    if (file != nullptr && given.count(file) == 0) ranks.try_emplace(file, ranks.size() + 1);
  }
  for (const base::SourceFile* file : files) ranks.try_emplace(file, ranks.size() + 1);
  const auto key = [&](const Diagnostic& diagnostic) {
    const base::SourceFile* const file = diagnostic.place.source.get();
    return file == nullptr ? std::pair<std::size_t, std::size_t>{}
                           : std::pair{ranks[file], diagnostic.place.span.begin};
  };
  std::stable_sort(all_.begin(), all_.end(), [&](const Diagnostic& a, const Diagnostic& b) { return key(a) < key(b); });
}

}  // namespace symplant::diag

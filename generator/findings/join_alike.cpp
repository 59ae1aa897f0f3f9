// Alike findings in devices of one type become one finding.
#include "findings/join_alike.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace symplant::findings {
namespace {

constexpr std::size_t kExamples = 3;

/// "`A`, `B`, `C` and 2 more".
std::string examples(const std::vector<std::string>& names) {
  const std::size_t shown = std::min(names.size(), kExamples);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) text += fmt::format("{}`{}`", i == 0 ? "" : ", ", names[i]);
  if (names.size() > shown) text += fmt::format(" and {} more", names.size() - shown);
  return text;
}

/// The first of several findings, and the names of the others.
struct Group {
  std::size_t first;
  std::vector<std::string> others;
};

}  // namespace

diag::Diagnostics join_alike(diag::Diagnostics findings) {
  const auto all = findings.all();
  if (std::all_of(all.begin(), all.end(), [](const auto& finding) { return finding.alike == nullptr; })) {
    return findings;
  }
  std::map<std::pair<const diag::RuleInfo*, std::string>, Group> groups;
  std::vector<diag::Diagnostic> kept;
  kept.reserve(all.size());
  for (const diag::Diagnostic& finding : all) {
    if (finding.alike == nullptr) {
      kept.push_back(finding);
      continue;
    }
    const auto [found, added] = groups.try_emplace({finding.rule, finding.alike->kind}, Group{kept.size(), {}});
    if (added) {
      kept.push_back(finding);
      continue;
    }
    Group& group = found->second;
    diag::Diagnostic& first = kept[group.first];
    first.severity = std::max(first.severity, finding.severity);
    first.shown_consequences += finding.shown_consequences;
    first.related.push_back({finding.location, fmt::format("also `{}`", finding.alike->name)});
    first.related.insert(first.related.end(), finding.related.begin(), finding.related.end());
    group.others.push_back(finding.alike->name);
  }
  if (kept.size() == all.size()) return findings;
  for (const auto& [key, group] : groups) {
    if (group.others.empty()) continue;
    kept[group.first].message += fmt::format("; {} more like this in devices named `{}`: {}", group.others.size(),
                                             key.second, examples(group.others));
  }
  diag::Diagnostics joined;
  for (diag::Diagnostic& finding : kept) joined.add(std::move(finding));
  for (const diag::Ignored& ignored : findings.ignored()) joined.ignore(ignored.finding, ignored.why);
  joined.leave_out(findings.left_out());
  return joined;
}

}  // namespace symplant::findings

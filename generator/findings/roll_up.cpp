// Joins findings by shape.
#include "findings/roll_up.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "text/ascii.hpp"

namespace symplant::findings {
namespace {

constexpr std::size_t kExamples = 3;

/// The name of what a finding is about.
const std::string& name_of(const diag::Diagnostic& finding) { return finding.subjects.about.front().name; }

/// The findings of one rule and shape.
struct Group {
  std::size_t count = 0;
  std::optional<std::size_t> first = {};  ///< where the first is kept
  std::vector<std::string> examples = {};
};

/// Each finding's group; null for one that stays single.
class Groups {
 public:
  explicit Groups(std::span<const diag::Diagnostic> findings) {
    for (const diag::Diagnostic& finding : findings) {
      const diag::Subjects& subjects = finding.subjects;
      if (subjects.about.empty() || subjects.shape.find('#') == std::string::npos) {
        of_.push_back(nullptr);
      } else {
        of_.push_back(&groups_[fmt::format("{} {}", finding.rule->id, text::to_upper(subjects.shape))]);
        ++of_.back()->count;
      }
    }
  }

  Group* of(std::size_t finding) const {
    return of_[finding] != nullptr && of_[finding]->count > 1 ? of_[finding] : nullptr;
  }

 private:
  std::unordered_map<std::string, Group> groups_;
  std::vector<Group*> of_;
};

void join(diag::Diagnostic& first, Group& group, diag::Diagnostic finding) {
  ++first.count;
  first.severity = std::max(first.severity, finding.severity);
  first.shown_consequences += finding.shown_consequences;
  first.related.push_back({std::move(finding.location), "also: " + std::move(finding.message)});
  std::move(finding.related.begin(), finding.related.end(), std::back_inserter(first.related));
  std::move(finding.renames.begin(), finding.renames.end(), std::back_inserter(first.renames));
  if (group.examples.size() < kExamples) group.examples.push_back(name_of(finding));
}

std::string others_text(const diag::Diagnostic& first, const Group& group) {
  const std::size_t more = group.count - 1 - group.examples.size();
  return fmt::format("; {} more like `{}`: `{}`{}", group.count - 1, first.subjects.shape,
                     fmt::join(group.examples, "`, `"), more == 0 ? "" : fmt::format(" and {} more", more));
}

}  // namespace

diag::Diagnostics roll_up(diag::Diagnostics findings) {
  std::vector<diag::Diagnostic> all = findings.take();
  const Groups groups(all);
  std::vector<diag::Diagnostic> kept;
  std::vector<const Group*> group_of;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Group* group = groups.of(i);
    if (group != nullptr && group->first) {
      join(kept[*group->first], *group, std::move(all[i]));
      continue;
    }
    if (group != nullptr) group->first = kept.size();
    kept.push_back(std::move(all[i]));
    group_of.push_back(group);
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (group_of[i] != nullptr) kept[i].message += others_text(kept[i], *group_of[i]);
    findings.add(std::move(kept[i]));
  }
  return findings;
}

}  // namespace symplant::findings

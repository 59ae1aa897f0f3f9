// Every rule of the tool.
#include "check/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "check/rules.hpp"
#include "description/description_rules.hpp"
#include "lower/limits.hpp"
#include "naming/rules.hpp"
#include "read/rules.hpp"
#include "symplant/tables/nearest.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

/// Slugs of earlier versions. Each still works, with a warning.
struct FormerSlug {
  std::string_view former;
  std::string_view now;
};
constexpr std::array kFormerSlugs{
    FormerSlug{"event-moved-twice", "event-driven-twice"},
    FormerSlug{"nobody-moves", "event-not-driven"},
    FormerSlug{"places-overlap", "symbols-overlap"},
};

}  // namespace

std::vector<const diag::RuleInfo*> catalogue() {
  std::vector<const diag::RuleInfo*> all(read::rules().begin(), read::rules().end());
  for (const Rule* rule : kRules) all.push_back(&rule->info);
  all.push_back(&lower::kPlantTooLarge);
  all.insert(all.end(), description::rules().begin(), description::rules().end());
  all.insert(all.end(), naming::rules().begin(), naming::rules().end());
  std::sort(all.begin(), all.end(), [](const auto* a, const auto* b) { return a->id < b->id; });
  return all;
}

const diag::RuleInfo* find_rule(std::string_view id_or_slug) {
  if (const std::string_view now = slug_now(id_or_slug); !now.empty()) id_or_slug = now;
  for (const diag::RuleInfo* rule : catalogue()) {
    if (text::equal_ignoring_case(rule->id, id_or_slug) || text::equal_ignoring_case(rule->slug, id_or_slug))
      return rule;
  }
  return nullptr;
}

std::string_view slug_now(std::string_view slug) {
  for (const FormerSlug& each : kFormerSlugs) {
    if (text::equal_ignoring_case(each.former, slug)) return each.now;
  }
  return {};
}

std::string renamed_rule(std::string_view former) { return fmt::format("`{}` is now `{}`", former, slug_now(former)); }

std::string no_such_rule(std::string_view name) {
  tables::NearestName nearest(name);
  for (const diag::RuleInfo* rule : catalogue()) {
    nearest.offer(rule->slug);
    nearest.offer(rule->id);
  }
  return fmt::format("unknown rule `{}`; {}", name,
                     nearest.name().empty() ? std::string("`symplant rules` lists all")
                                            : fmt::format("did you mean `{}`?", nearest.name()));
}

bool is_stopping(const diag::Diagnostic& finding) {
  return finding.severity == diag::Severity::error && finding.rule != &kNoDevice.info;
}

bool has_stopping_errors(const diag::Diagnostics& findings) {
  const auto all = findings.all();
  return findings.has_errors() && std::any_of(all.begin(), all.end(), is_stopping);
}

}  // namespace symplant::check

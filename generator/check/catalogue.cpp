// Every rule of the tool.
#include "check/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "check/rules.hpp"
#include "description/description_rules.hpp"
#include "lower/limits.hpp"
#include "read/rules.hpp"
#include "symplant/tables/nearest.hpp"
#include "text/ascii.hpp"

namespace symplant::check {

std::vector<const diag::RuleInfo*> catalogue() {
  std::vector<const diag::RuleInfo*> all(read::rules().begin(), read::rules().end());
  for (const Rule* rule : kRules) all.push_back(&rule->info);
  all.push_back(&lower::kPlantTooLarge);
  all.insert(all.end(), description::rules().begin(), description::rules().end());
  std::sort(all.begin(), all.end(), [](const auto* a, const auto* b) { return a->id < b->id; });
  return all;
}

const diag::RuleInfo* find_rule(std::string_view id_or_slug) {
  for (const diag::RuleInfo* rule : catalogue()) {
    if (text::equal_ignoring_case(rule->id, id_or_slug) || text::equal_ignoring_case(rule->slug, id_or_slug))
      return rule;
  }
  return nullptr;
}

std::string no_such_rule(std::string_view name) {
  tables::NearestName nearest(name);
  for (const diag::RuleInfo* rule : catalogue()) {
    nearest.offer(rule->slug);
    nearest.offer(rule->id);
  }
  return fmt::format("there is no rule `{}`{}", name,
                     nearest.name().empty() ? std::string(": `symplant rules` lists all")
                                            : fmt::format(", the nearest is `{}`", nearest.name()));
}

}  // namespace symplant::check

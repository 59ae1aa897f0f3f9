// The catalogue: stable ids and slugs, pages for every rule, and the published page.
#include "check/catalogue.hpp"

#include <set>
#include <sstream>

#include "app/tool.hpp"
#include "check/rules.hpp"
#include "description/description_rules.hpp"
#include "naming/rules.hpp"
#include "read/rules.hpp"
#include "support/catch.hpp"
#include "support/golden.hpp"
#include "support/memory_file_system.hpp"
#include "support/tool.hpp"
#include "text/ascii.hpp"

namespace symplant::test {
namespace {

TEST_CASE("Rules are sorted by id, each id and slug once") {
  std::set<std::string_view> slugs;
  std::string_view before;
  for (const diag::RuleInfo* rule : check::catalogue()) {
    INFO(rule->id);
    CHECK(before < rule->id);
    before = rule->id;
    CHECK(slugs.insert(rule->slug).second);
  }
  const std::size_t of_lower = 1;
  CHECK(check::catalogue().size() ==
        check::kRules.size() + read::rules().size() + description::rules().size() + naming::rules().size() + of_lower);
}

TEST_CASE("Every rule has a summary without a full stop and a page with the fix") {
  for (const diag::RuleInfo* rule : check::catalogue()) {
    INFO(rule->id);
    CHECK_FALSE(rule->summary.empty());
    CHECK(rule->summary.back() != '.');
    CHECK(rule->page.size() > 80);
    CHECK(rule->page.back() == '\n');
  }
  for (const check::Rule* rule : check::kRules) {
    if (rule->info.severity == diag::Severity::note) continue;
    INFO(rule->info.id);
    CHECK(rule->info.page.find("**What the model loses.**") != std::string_view::npos);
    CHECK(rule->info.page.find("**How to fix it.**") != std::string_view::npos);
  }
}

TEST_CASE("A rule is found by id and by slug in any case") {
  for (const diag::RuleInfo* rule : check::catalogue()) {
    CHECK(check::find_rule(rule->id) == rule);
    CHECK(check::find_rule(rule->slug) == rule);
  }
  CHECK(check::find_rule("sp201") == check::find_rule("Wrong-Number-Of-Levels"));
  CHECK(check::find_rule("SP999") == nullptr);
  CHECK(check::find_rule("") == nullptr);
}

TEST_CASE("A former slug finds the current rule, and no current slug is a former one") {
  for (const auto& [former, now] : {std::pair{"nobody-moves", "event-not-driven"},
                                    {"event-moved-twice", "event-driven-twice"},
                                    {"places-overlap", "symbols-overlap"}}) {
    INFO(former);
    REQUIRE(check::find_rule(former) != nullptr);
    CHECK(check::find_rule(former)->slug == now);
    CHECK(check::slug_now(text::to_upper(former)) == now);
    CHECK(check::slug_now(now).empty());
  }
  for (const diag::RuleInfo* rule : check::catalogue()) CHECK(check::slug_now(rule->slug).empty());
}

TEST_CASE("docs/rules.md equals the output of the tool") {
  const ToolRun run = run_tool({"rules"});
  CHECK(run.code == 0);
  CHECK(run.err.empty());
  check_golden(std::string(SYMPLANT_SOURCE_DIR) + "/docs/rules.md", run.out);
}

}  // namespace
}  // namespace symplant::test

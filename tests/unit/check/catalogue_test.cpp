// The catalogue: stable ids and slugs, pages for every rule, and the published page.
#include "check/catalogue.hpp"

#include <fmt/format.h>

#include <set>
#include <sstream>

#include "app/tool.hpp"
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
}

TEST_CASE("Every rule has a summary without a full stop and a page with the fix") {
  for (const diag::RuleInfo* rule : check::catalogue()) {
    INFO(rule->id);
    CHECK_FALSE(rule->summary.empty());
    CHECK(rule->summary.back() != '.');
    CHECK(rule->page.size() > 30);
    const std::string page = diag::manual_page(*rule);
    CHECK(page.back() == '\n');
    if (rule->severity == diag::Severity::note || rule->id == "SP701") continue;
    CHECK(page.find("\n**What the model loses.**") != std::string::npos);
    CHECK(page.find("\n**How to fix it.**") != std::string::npos);
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

TEST_CASE("A former name finds the rule that replaces it, and no current name is a former one") {
  for (const auto& [former, now] : {std::pair{"nobody-moves", "event-not-driven"},
                                    {"event-moved-twice", "event-driven-twice"},
                                    {"Role-Taken", "naming-ambiguous"},
                                    {"sp320", "addresses-overlap"}}) {
    INFO(former);
    REQUIRE(check::find_rule(former) != nullptr);
    CHECK(check::find_rule(former)->slug == now);
    CHECK(check::former_rule(former) == fmt::format("`{}` is now `{}`", former, now));
  }
  for (const diag::RuleInfo* rule : check::catalogue()) {
    CHECK(check::former_rule(rule->slug).empty());
    CHECK(check::former_rule(rule->id).empty());
  }
}

TEST_CASE("A removed rule is not found, and is not unknown") {
  for (const char* removed : {"SP312", "byte-on-no-register", "condition-not-examined", "SP5"}) {
    INFO(removed);
    CHECK(check::find_rule(removed) == nullptr);
    CHECK(check::former_rule(removed) == fmt::format("the rule `{}` no longer exists", removed));
  }
}

TEST_CASE("docs/rules.md equals the output of the tool") {
  const ToolRun run = run_tool({"rules"});
  CHECK(run.code == 0);
  CHECK(run.err.empty());
  check_golden(std::string(SYMPLANT_SOURCE_DIR) + "/docs/rules.md", run.out);
}

}  // namespace
}  // namespace symplant::test

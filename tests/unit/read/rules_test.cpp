// The catalogue of the rules of reading.
#include "read/rules.hpp"

#include <set>

#include "read_support.hpp"
#include "support/strings.hpp"

using namespace symplant;

TEST_CASE("Rules of reading are sorted by id, with a unique name and a complete manual page") {
  std::string_view last;
  std::set<std::string_view> slugs;
  for (const diag::RuleInfo* rule : read::rules()) {
    INFO(rule->id);
    CHECK(rule->id > last);
    CHECK(test::contains(rule->id, "SP1"));
    CHECK(rule->id.size() == 5);
    CHECK(slugs.insert(rule->slug).second);
    CHECK_FALSE(rule->summary.empty());
    CHECK(test::contains(rule->page, "**What the model loses.**"));
    CHECK(test::contains(rule->page, "**How to fix it.**"));
    CHECK(rule->page.back() == '\n');
    last = rule->id;
  }
}

TEST_CASE("Each rule of reading fires on a golden or is named here") {
  std::set<std::string_view> fired{"SP101", "SP106", "SP122"};  // no file can trigger them: readers_test.cpp does
  fired.insert("SP111");                                        // a file of 65 KB: gx_iec_test.cpp makes it
  fired.insert("SP119");                                        // an array of 4,097 elements: arrays_test.cpp makes it
  for (const std::string folder : {"bad/", "formats/"}) {
    for (const std::string& file : test::lists_in(test::kGoldens + folder)) {
      const test::Reading reading = test::read_golden(test::kGoldens + folder + file);
      for (const diag::Diagnostic& finding : reading.diagnostics.all()) fired.insert(finding.rule->id);
    }
  }
  for (const diag::RuleInfo* rule : read::rules()) {
    INFO(rule->id);
    CHECK(fired.count(rule->id) == 1);
  }
}

// Locations known as JSON pointers, until the text of the file is searched for all of them.
#include "diag/diagnostic.hpp"
#include "support/catch.hpp"

namespace symplant::test {
namespace {

constexpr diag::RuleInfo kSomeRule{"SP999", "some-rule", diag::Severity::warning, "summary", "page"};

diag::Location at(std::string pointer) { return {nullptr, {}, std::move(pointer)}; }

TEST_CASE("Pointers of all locations are listed once, sorted, and each location gets its file and span") {
  const auto list = std::make_shared<const text::SourceFile>("symbols.csv", "A\n");
  const auto file = std::make_shared<const text::SourceFile>("plant.json", "{ \"a\": 1, \"b\": 2 }");
  diag::Diagnostics found;
  found.add(kSomeRule, "first", at("/b"), {{at("/a"), "other"}});
  found.add(kSomeRule, "second", at("/b"));
  found.add(kSomeRule, "third", {list, {0, 1}});
  found.add(kSomeRule, "fourth", {list, {0, 1}, "/c"});
  CHECK(found.pointers() == std::vector<std::string>{"/a", "/b", "/c"});

  const auto included = std::make_shared<const text::SourceFile>("learned.json", "{ \"c\": 3 }");
  const std::vector<diag::Location> locations{{file, {2, 5}}, {file, {10, 13}}, {included, {2, 5}}};
  found.locate(locations);
  const auto all = found.all();
  CHECK(all[0].location.source == file);
  CHECK(all[0].location.span.begin == 10);
  CHECK(all[0].related[0].location.span.begin == 2);
  CHECK(all[1].location.span.end == 13);
  CHECK(all[2].location.source == list);
  CHECK(all[3].location.source == included);
  CHECK(found.pointers().empty());
}

TEST_CASE("A finding has its rule's severity unless another is set, and counts by it") {
  diag::Diagnostics found;
  found.add(kSomeRule, "as it is", {});
  found.add({&kSomeRule, diag::Severity::error, "raised", {}, {}, {}});
  CHECK(found.count(diag::Severity::warning) == 1);
  CHECK(found.has_errors());
  found.ignore({&kSomeRule, diag::Severity::error, "ignored", {}, {}, {}}, "meant to be");
  CHECK(found.count(diag::Severity::error) == 1);
  CHECK(found.all().size() == 2);
  CHECK(found.ignored().size() == 1);
}

TEST_CASE("A manual page has its sections in lines of at most 120 characters, or as its rule writes it") {
  const std::string words = "one two three four five six seven eight nine ten eleven twelve thirteen fourteen";
  const std::string twice = words + " " + words;
  const diag::RuleInfo rule{"SP1", "s", diag::Severity::note, "", words, diag::Rank::last, twice, "Write it."};
  CHECK(diag::manual_page(rule) == words + "\n\n**What the model loses.** " + words + " one two three\n" +
                                       words.substr(14) + "\n\n**How to fix it.** Write it.\n");
  const std::string line(130, 'a');
  CHECK(diag::manual_page({"SP1", "s", diag::Severity::note, "", line}) == line + "\n");
  CHECK(diag::manual_page({"SP1", "s", diag::Severity::note, "", "One.\n\nTwo.\n"}) == "One.\n\nTwo.\n");
}

TEST_CASE("A severity is found by its word") {
  CHECK(diag::severity_of_name("note") == diag::Severity::note);
  CHECK(diag::severity_of_name("error") == diag::Severity::error);
  CHECK_FALSE(diag::severity_of_name("Error"));
}

}  // namespace
}  // namespace symplant::test

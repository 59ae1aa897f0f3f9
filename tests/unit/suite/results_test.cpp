// Results, their files, and what is made of them.
#include <sstream>

#include "suite/report.hpp"
#include "suite/result.hpp"
#include "support/catch.hpp"
#include "support/strings.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::suite {
namespace {

using test::contains;
using test::TemporaryFolder;
using Verdict = Result::Verdict;

Result result(std::string name, Verdict verdict, std::vector<std::string> messages = {}) {
  return {std::move(name), Speed::normal, verdict, Result::Reference::same, 0.5, std::move(messages), ""};
}

std::string merged(const std::vector<std::string>& files) {
  batch::Header header;
  std::string names;
  const std::string error =
      batch::read_results<Result>(files, kResultKey, header, [&](std::size_t number, const Result& one) {
        names += std::to_string(number) + one.title() + " ";
        return "";
      });
  return error.empty() ? names : error;
}

TEST_CASE("A result is the same after it was written and read") {
  Result one = result("a \"b\"", Verdict::failed, {"at 1 s: `X` late", "second"});
  one.speed = Speed::fast;
  one.reference = Result::Reference::differs;
  one.chart = R"({"x":1})";
  const auto again = Result::of_line(one.line());
  REQUIRE(again);
  CHECK(again->title() == "a \"b\" on the fast plant");
  CHECK(again->verdict == one.verdict);
  CHECK(again->reference == one.reference);
  CHECK(again->messages == one.messages);
  CHECK(again->chart == one.chart);
  CHECK_FALSE(Result::of_line(R"({"case":"a"})"));
  CHECK_FALSE(Result::of_line("text"));
  CHECK_FALSE(Result::of_line(""));
}

TEST_CASE("Files of parts are one suite, what does not fit together is refused") {
  const TemporaryFolder folder;
  std::string error;
  {
    Results first({kResultKey, "suite", 3}, folder / "1.jsonl", error);
    CHECK(first.add(2, result("c", Verdict::passed)).empty());
    CHECK(first.add(0, result("a", Verdict::passed)).empty());
    CHECK(first.read(0).name == "a");
    CHECK(first.read(2).name == "c");
    CHECK_FALSE(first.has(1));
    Results second({kResultKey, "suite", 3}, folder / "2.jsonl", error);
    CHECK(second.add(1, result("b", Verdict::passed)).empty());
    Results other({kResultKey, "suite", 4}, folder / "3.jsonl", error);
  }
  CHECK(error.empty());
  CHECK(merged({folder / "1.jsonl", folder / "2.jsonl"}) == "2c 0a 1b ");
  CHECK(contains(merged({folder / "1.jsonl", folder / "1.jsonl"}), "`c` is in `" + (folder / "1.jsonl") + "` already"));
  CHECK(contains(merged({folder / "1.jsonl", folder / "3.jsonl"}), "the earlier files are of `suite` with 3"));
  CHECK(contains(merged({folder / "no.jsonl"}), "cannot read"));
  folder.write("text.jsonl", "text\n");
  CHECK(contains(merged({folder / "text.jsonl"}), "text.jsonl:1: these are no results"));
  folder.write("odd.jsonl", "{\"symplant-test\":1,\"of\":\"suite\",\"results\":3,\"more\":0}\n{\"number\":7}\n");
  CHECK(contains(merged({folder / "odd.jsonl"}), "odd.jsonl:2: this is no result"));
}

TEST_CASE("The last line of a process that was killed is left out") {
  const TemporaryFolder folder;
  const std::string header = "{\"symplant-test\":1,\"of\":\"suite\",\"results\":3,\"more\":0}\n";
  const std::string line = "{\"number\":0," + result("a", Verdict::passed).line().substr(1) + "\n";
  const std::string path = folder.write("cut.jsonl", header + line + line.substr(0, 40));
  CHECK(merged({path}) == "0a ");
}

TEST_CASE("A suite is good only if every case has passed and none is missing") {
  Counts counts;
  counts.add(result("a", Verdict::passed));
  CHECK(counts.well());
  CHECK(summary(counts) == "1 case: 1 passed, 0 failed");
  Counts missing = counts;
  missing.missing = 1;
  CHECK_FALSE(missing.well());
  CHECK(contains(summary(missing), "1 without a result"));
  Counts failed = counts;
  failed.add(result("b", Verdict::failed));
  CHECK_FALSE(failed.well());
  counts.add(result("c", Verdict::error));
  CHECK_FALSE(counts.well());
  CHECK(summary(counts) == "2 cases: 1 passed, 0 failed, 1 error");
}

TEST_CASE("The reports have each case with its words") {
  std::string error;
  Results results({kResultKey, "suite", 3}, "", error);
  CHECK(results.add(0, result("good", Verdict::passed)).empty());
  CHECK(results.add(1, result("late", Verdict::failed, {"at 1 s: `X` late by 1 s: on"})).empty());
  CHECK(results.add(2, result("crash", Verdict::error, {"program `cell` ended by SIGSEGV"})).empty());
  const std::string xml = junit_text(results, {});
  CHECK(contains(xml, "tests=\"3\" failures=\"1\" errors=\"1\""));
  CHECK(contains(xml, "name=\"late\""));
  CHECK(contains(xml, "<error message=\"program `cell` ended by SIGSEGV"));
  Counts counts;
  const std::string page = base::text_of([&](base::TextSink& sink) { write_html(results, counts, sink); });
  CHECK(contains(page, "\"title\":\"late\""));
  CHECK(contains(page, "late by 1 s"));
  CHECK_FALSE(contains(page, "@script@"));
  std::ostringstream out;
  write_result(results.read(1), out);
  CHECK(out.str() == "FAILED late\n    at 1 s: `X` late by 1 s: on\n");
}

}  // namespace
}  // namespace symplant::suite

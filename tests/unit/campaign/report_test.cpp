// Results of a campaign, their order, and the reports.
#include "campaign/report.hpp"

#include <sstream>

#include "support/catch.hpp"
#include "support/strings.hpp"

namespace symplant::campaign {
namespace {

using test::contains;

Result result(std::string item, Class is) {
  Result one;
  one.item = std::move(item);
  one.mode = "stuck on";
  one.phase = "from the start";
  one.is = is;
  one.reaction = "no operation changes after 1 s; 2 differences";
  one.command = "symplant run";
  return one;
}

struct Some {
  Some() : results({kResultKey, "plant", 5, R"({"about":[["Base case","base.json"]],"alarms":1})"}, "", error) {
    Result detected = result("=D", Class::detected);
    detected.alarms = {"HORN", "LAMP"};
    detected.detection = 1'500'000'000;
    detected.end = "works on";
    detected.seen_at = 10'000'000;
    detected.chart =
        R"({"series":[{"name":"X","base":[1,1],"run":[2,1]}],"differences":[],"end":9,"left_out":0,"cut":false})";
    Result idle = result("N", Class::no_effect);
    idle.ran = false;
    CHECK(results.add(0, idle).empty());
    CHECK(results.add(1, detected).empty());
    CHECK(results.add(2, result("U", Class::undetected)).empty());
    CHECK(results.add(3, result("</script>V", Class::violated)).empty());
    CHECK(results.add(4, result("E", Class::error)).empty());
  }
  std::string error;
  Results results;
};

TEST_CASE("A result is the same after it was written and read") {
  Result one = result("a \"b\"", Class::no_effect);
  one.more = "X0, comment";
  one.at = 12;
  one.seen = "X on";
  one.on = {"A", "B"};
  one.ran = false;
  one.chart = R"({"series":[],"differences":[],"end":5,"left_out":0,"cut":false})";
  one.requirement = "r";
  one.failed_step = "base.json:3: x";
  one.end = "works on";
  const auto again = Result::of_line(one.line());
  REQUIRE(again);
  CHECK(again->line() == one.line());
  CHECK(again->title() == "a \"b\" stuck on, from the start");
  CHECK_FALSE(Result::of_line("text"));
  CHECK_FALSE(Result::of_line(R"({"class":"strange"})"));
  std::string damaged = one.line();
  damaged.replace(damaged.find("\"at\":12"), 7, "\"at\":-7");
  CHECK_FALSE(Result::of_line(damaged));
  one.chart = "{}";
  CHECK_FALSE(Result::of_line(one.line()));
}

TEST_CASE("Classes have names, and the worst comes first") {
  for (std::size_t i = 0; i < kClasses; ++i) {
    const auto one = static_cast<Class>(i);
    CHECK(class_of(class_name(one)) == one);
  }
  CHECK(class_of("no-effect") == Class::no_effect);
  CHECK_FALSE(class_of("noeffect"));
  const Some some;
  const Overview overview = overview_of(some.results);
  CHECK(overview.numbers == std::vector<std::size_t>{4, 3, 2, 1, 0});
  CHECK(summary(overview) ==
        "5 faults: 1 error, 1 violated, 1 undetected, 1 detected, 1 no effect (1 not run: they hold what the base case "
        "shows)");
}

TEST_CASE("A campaign fails by its classes, by errors and by missing results") {
  Overview overview;
  Classes violated;
  violated.set(static_cast<std::size_t>(Class::violated));
  CHECK_FALSE(fails(overview, violated));
  overview.counts[static_cast<std::size_t>(Class::undetected)] = 1;
  CHECK_FALSE(fails(overview, violated));
  overview.counts[static_cast<std::size_t>(Class::violated)] = 1;
  CHECK(fails(overview, violated));
  CHECK_FALSE(fails(overview, {}));
  overview.missing = 1;
  CHECK(fails(overview, {}));
  overview.missing = 0;
  overview.counts[static_cast<std::size_t>(Class::error)] = 1;
  CHECK(fails(overview, {}));
}

TEST_CASE("The reports have each fault, worst first, and no text of theirs is code") {
  const Some some;
  const Overview overview = overview_of(some.results);
  const std::string csv = base::text_of([&](base::TextSink& sink) { write_csv(some.results, overview, sink); });
  CHECK(contains(csv, "'=D,,stuck on,from the start,0,detected,,0.01,"));
  CHECK(contains(csv, ",\"HORN; LAMP\",1.5,works on,,,,symplant run\n"));
  CHECK(csv.find("\nE,") < csv.find("\n</script>V,"));
  Classes fail_on;
  fail_on.set(static_cast<std::size_t>(Class::violated));
  const std::string xml = junit_text(some.results, overview, fail_on);
  CHECK(contains(xml, "tests=\"5\" failures=\"1\" errors=\"1\""));
  const std::string page = base::text_of([&](base::TextSink& sink) { write_html(some.results, overview, sink); });
  CHECK_FALSE(contains(page, "</script>V"));
  CHECK(contains(page, "\"base\":[[1,1]]"));
  CHECK(contains(page, "[\"X\",0,[2,1]]"));
  CHECK_FALSE(contains(page, "@data@\","));
  std::ostringstream out;
  write_table(some.results, overview, 2, out);
  CHECK(contains(out.str(), "error       E stuck on"));
  CHECK(contains(out.str(), "no operation changes after 1 s\n"));
  std::ostringstream few;
  write_table(some.results, overview, 0, few);
  CHECK(contains(few.str(), "undetected  ... and 1 more"));
}

}  // namespace
}  // namespace symplant::campaign

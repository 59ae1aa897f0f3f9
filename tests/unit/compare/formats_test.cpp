// The forms in which a comparison is shown.
#include "compare/formats.hpp"

#include <nlohmann/json.hpp>

#include "base/text_source.hpp"
#include "compare_support.hpp"

namespace symplant::test {
namespace {

using Json = nlohmann::json;

std::string shown(const Compared& compared, void (*write)(const compare::Comparison&, base::TextSink&)) {
  return base::text_of([&](base::TextSink& sink) { write(compared.comparison, sink); });
}

/// 30 pulses, of which ACTUAL has none, and a late change.
Compared many() {
  std::string expected = "5 Y 1";
  for (int i = 1; i <= 30; ++i)
    expected += "; " + std::to_string(10 * i) + " X 1; " + std::to_string(10 * i + 5) + " X 0";
  return {expected + "; 400", "9 Y 1; 400"};
}

TEST_CASE("Text has the first 20 differences, then counts of each element") {
  const std::string text = shown(many(), compare::write_text);
  CHECK(contains(text,
                 "good.jsonl (expected, to 0.4 s) | run.jsonl (actual, to 0.4 s); window 0 s\n"
                 "at 0.005 s: `Y` late by 0.004 s: on\n"
                 "at 0.01 s: `X` missing: on for 0.005 s\n"));
  CHECK(contains(text,
                 "... and 11 more; of each element:\n"
                 "    30  `X`, first at 0.01 s: `X` missing: on for 0.005 s\n"
                 "     1  `Y`, first at 0.005 s: `Y` late by 0.004 s: on\n"
                 "31 differences in 2 of 2 elements: 30 missing, 1 late\n"));
  CHECK(contains(shown({"10 X 1", "10 X 1"}, compare::write_text), "no difference: 1 change of 1 element agree\n"));
}

TEST_CASE("JSON has every difference") {
  const Json json = Json::parse(shown(many(), compare::write_json));
  CHECK(json["symplant-compare"] == 1);
  CHECK(json["equal"] == false);
  REQUIRE(json["differences"].size() == 31);
  CHECK(json["differences"][0] ==
        Json({{"kind", "late"}, {"t", 5'000'000}, {"symbol", "Y"}, {"expected", true}, {"by", 4'000'000}}));
  CHECK(json["differences"][1] ==
        Json({{"kind", "missing"}, {"t", 10'000'000}, {"symbol", "X"}, {"expected", true}, {"pulse", 5'000'000}}));
  const Json ends = Json::parse(shown({"10 X 1; 20 body@OUT; 30", "10 X 1; 15 body@OUT; 30"}, compare::write_json));
  CHECK(ends["differences"][0] == Json({{"kind", "early"},
                                        {"t", 20'000'000},
                                        {"location", "OUT"},
                                        {"kind_of_part", "body"},
                                        {"expected", true},
                                        {"by", 5'000'000}}));
}

TEST_CASE("JUnit has a test case for each element, and one for the ends") {
  const std::string xml = shown(many(), compare::write_junit);
  CHECK(contains(xml, "tests=\"3\" failures=\"2\""));
  CHECK(contains(xml, "name=\"X\""));
  CHECK(contains(xml, "... and 10 differences more"));
  CHECK(contains(xml, "name=\"end of the traces\" time=\"0.4\"/>"));
}

TEST_CASE("HTML has both traces and the differences as data, and nothing ends its script early") {
  const std::string html = shown({"10 X</script><b> 1; 30", "20 X</script><b> 1; 30"}, compare::write_html);
  const std::string begin = "<script type=\"application/json\" id=\"data\">";
  const std::size_t at = html.find(begin);
  REQUIRE(at != html.npos);
  const std::size_t end = html.find("</script>", at);
  const Json data = Json::parse(html.substr(at + begin.size(), end - at - begin.size()));
  CHECK(data["series"][0]["name"] == "X</script><b>");
  CHECK(data["series"][0]["expected"] == Json({10'000'000, 1.0}));
  CHECK(data["differences"][0]["from"] == 10'000'000);
  CHECK(data["differences"][0]["to"] == 20'000'000);
  CHECK(data["differences"][0]["words"] == "late by 0.01 s: on");
}

}  // namespace
}  // namespace symplant::test

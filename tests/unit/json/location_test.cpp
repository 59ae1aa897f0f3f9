// Locations of values in a JSON text.
#include "symplant/json/location.hpp"

#include <string>

#include "support/catch.hpp"

namespace symplant::json {
namespace {

const std::string kText = R"({ // a comment with "quotes"
  "devices": {
    "A/B~": { "initial": "P1", "only": true, "n": -12.5e+1, "list": [1, "two\"", {"x": null}] },
    "A": []
  }
})";

std::string at(const std::string& pointer, bool at_key = false) {
  const Fault fault{pointer, "", 0, at_key};
  const Span span = spans(kText, {&fault, 1})[0];
  return kText.substr(span.begin, span.end - span.begin);
}

TEST_CASE("Scalars are found with their own span") {
  CHECK(at("/devices/A~1B~0/initial") == "\"P1\"");
  CHECK(at("/devices/A~1B~0/only") == "true");
  CHECK(at("/devices/A~1B~0/n") == "-12.5e+1");
  CHECK(at("/devices/A~1B~0/list/0") == "1");
  CHECK(at("/devices/A~1B~0/list/1") == R"("two\"")");
  CHECK(at("/devices/A~1B~0/list/2/x") == "null");
}

TEST_CASE("An object or array is found by its key, or by its bracket without a key") {
  CHECK(at("/devices") == "\"devices\"");
  CHECK(at("/devices/A") == "\"A\"");
  CHECK(at("/devices/A~1B~0/list/2") == "{");
  CHECK(at("") == "{");
}

TEST_CASE("The key is found if the key is at fault") {
  CHECK(at("/devices/A~1B~0/initial", true) == "\"initial\"");
  CHECK(at("/devices/A~1B~0/list/1", true) == R"("two\"")");  // an item has no key
}

TEST_CASE("A pointer to a missing value finds the nearest value above it") {
  CHECK(at("/devices/A/3/x") == "\"A\"");
  CHECK(at("/nothing") == "{");
}

TEST_CASE("Many values are found in one pass, each with its own span") {
  const std::vector<Fault> faults{{"/devices/A", "one"}, {"/devices/A~1B~0/only", "two"}, {"/devices/A", "three"}};
  const std::vector<Placed> placed = locate(kText, faults);
  REQUIRE(placed.size() == 3);
  CHECK(placed[0].span == placed[2].span);
  CHECK(placed[1].message == "two");
  CHECK(kText.substr(placed[1].span.begin, 4) == "true");
}

TEST_CASE("A column is found after escapes") {
  const std::string text = R"({"when": "\u00e4\ud83d\ude00 \"A\".P1 and B"})";
  const std::string decoded = "\xC3\xA4\xF0\x9F\x98\x80 \"A\".P1 and B";
  const Fault fault{"/when", "no such device", decoded.find('B')};
  const Placed placed = locate(text, {&fault, 1})[0];
  CHECK(text.substr(placed.span.begin, placed.span.end - placed.span.begin) == "B\"");
  const Fault behind{"/when", "more is wanted", decoded.size()};
  CHECK(text[locate(text, {&behind, 1})[0].span.begin] == '"');
}

TEST_CASE("Lines and columns count from one, columns in characters") {
  CHECK(line_and_column("", 0).line == 1);
  CHECK(line_and_column("\xEF\xBB\xBF{", 3).column == 1);
  const std::string text = "a\n\xC3\xA4x\n";
  CHECK(line_and_column(text, 4).line == 2);
  CHECK(line_and_column(text, 4).column == 2);
  CHECK(line_and_column(text, 999).line == 3);
}

TEST_CASE("Pointers are extended with escapes") {
  CHECK(child("/a", "b/c~") == "/a/b~1c~0");
  CHECK(child("", std::size_t{7}) == "/7");
}

}  // namespace
}  // namespace symplant::json

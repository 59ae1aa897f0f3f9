// JSON texts as values, and rejected texts.
#include "symplant/json/document.hpp"

#include <nlohmann/json.hpp>
#include <string>

#include "support/catch.hpp"

namespace symplant::json {
namespace {

std::string under(std::string_view text, Span span) {
  return std::string(text.substr(span.begin, span.end - span.begin));
}

/// The only fault of a text.
Placed fault_of(std::string_view text) {
  const Document document = parse(text);
  REQUIRE(document.faults.size() == 1);
  return document.faults[0];
}

TEST_CASE("A text with comments and a byte order mark is read") {
  const Document document =
      parse("\xEF\xBB\xBF// head\n{ \"a\": [1, -2, 2.5, true, null, /* in */ \"\\u00e4\"], \"b\": {} }\n");
  REQUIRE(document.root != nullptr);
  CHECK(document.faults.empty());
  CHECK(*document.root == nlohmann::json::parse(R"({"a":[1,-2,2.5,true,null,"ä"],"b":{}})"));
}

TEST_CASE("Numbers of 64 bits are read exactly") {
  const Document document = parse("[18446744073709551615, -9223372036854775808]");
  CHECK((*document.root)[0].get<std::uint64_t>() == 18446744073709551615U);
  CHECK((*document.root)[1].get<std::int64_t>() == INT64_MIN);
}

TEST_CASE("A duplicate key is reported with both locations, and the first counts") {
  const std::string text = R"({"a": {"x": 1, "y": {"q": 1}, "y": {"q": 2, "r": [{}]}}, "b": 3})";
  const Document document = parse(text);
  REQUIRE(document.faults.size() == 1);
  const Placed& fault = document.faults[0];
  CHECK(fault.message == "the key `y` is repeated; remove one of the two");
  CHECK(fault.span.begin == text.rfind("\"y\""));
  REQUIRE(fault.related);
  CHECK(fault.related->span.begin == text.find("\"y\""));
  CHECK((*document.root)["a"]["y"]["q"] == 1);
  CHECK((*document.root)["b"] == 3);
}

TEST_CASE("At most a hundred duplicate keys are reported, and at most a hundred NULs") {
  std::string keys = "{";
  std::string nuls = "[";
  for (int i = 0; i < 1'000; ++i) {
    keys += "\"a\": 1,";
    nuls += "\"\\u0000\",";
  }
  CHECK(parse(keys + "\"b\": 1}").faults.size() == 100);
  CHECK(parse(nuls + "1]").faults.size() == 100);
}

TEST_CASE("Invalid JSON is reported at its first wrong character") {
  const std::string text = "{\n  \"a\": tru,\n}";
  const Placed fault = fault_of(text);
  CHECK(fault.message.starts_with("this is not valid JSON: invalid literal"));
  CHECK(line_and_column(text, fault.span.begin).line == 2);
  CHECK(parse(text).root == nullptr);
}

TEST_CASE("A message contains whole characters, wherever the library stopped reading") {
  // The library stops at the first byte of the character, which is not JSON.
  CHECK(fault_of("\xE7\x8D\xB0").message.find('\xE7') == std::string::npos);
  for (std::size_t before = 100; before < 180; ++before) {
    const std::string message = fault_of("\"" + std::string(before, 'x') + "\xC3\xA4\xC3\xA4\xC3\xA4\n\"").message;
    for (std::size_t at = 0; at < message.size(); ++at) {
      if (message[at] != '\xC3') continue;
      CHECK(at + 1 < message.size());
      CHECK(message.substr(at + 1, 1) == "\xA4");
    }
  }
}

TEST_CASE("A superfluous comma is reported as such") {
  const std::string text = R"({"a": [1, 2, ]})";
  const Placed fault = fault_of(text);
  CHECK(fault.message.starts_with("this is not valid JSON: remove the comma before the closing bracket"));
  CHECK(under(text, fault.span) == "]");
}

TEST_CASE("Texts that end too early, are empty, or are invalid UTF-8, are rejected") {
  for (const std::string_view text : {"", "  ", "{", "{\"a\"", "[1", "\"a", "// only", "/* open", "{\"a\":1} x",
                                      "\"\xFF\"", "\"\\ud800\"", "1e999", "nul"}) {
    CAPTURE(text);
    const Document document = parse(text);
    CHECK(document.root == nullptr);
    CHECK(document.faults.size() == 1);
    for (const Placed& fault : document.faults) CHECK(fault.span.end <= text.size());
  }
}

TEST_CASE("A NUL in a text or key is rejected") {
  const std::string text = R"({"a": "x\u0000y", "b\u0000": 1})";
  const Document document = parse(text);
  REQUIRE(document.faults.size() == 2);
  CHECK(under(text, document.faults[0].span) == R"("x\u0000y")");
  CHECK(under(text, document.faults[1].span) == R"("b\u0000")");
}

TEST_CASE("A hundred levels are read, one more is rejected, and a million are rejected as quickly") {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  CHECK(parse(nested(100)).faults.empty());
  CHECK(fault_of(nested(101)).message.find("the limit is 100") != std::string::npos);
  CHECK(fault_of(nested(1'000'000)).span.begin == 100);
}

TEST_CASE("A text cut at any byte is rejected or read, and its fault lies within it") {
  const std::string text = R"({"a": [1, {"b": "\u00e4\n", "c": -1.5e3}], /* x */ "d": true})";
  for (std::size_t size = 0; size < text.size(); ++size) {
    const Document document = parse(text.substr(0, size));
    REQUIRE(document.faults.size() == 1);
    CHECK(document.faults[0].span.end <= size);
  }
}

}  // namespace
}  // namespace symplant::json

// What a value lacks to fit a schema, in words.
#include "symplant/json/schema.hpp"

#include <nlohmann/json.hpp>
#include <string>

#include "support/catch.hpp"

namespace symplant::json {
namespace {

constexpr std::string_view kSchema = R"({
  "$schema": "http://json-schema.org/draft-07/schema#",
  "type": "object",
  "required": ["version"],
  "additionalProperties": false,
  "properties": {
    "version": { "const": 1, "title": "the version of the format, 1" },
    "devices": { "type": "object", "additionalProperties": { "$ref": "#/definitions/device" } },
    "count": { "type": "integer", "minimum": 1, "title": "a count from 1 on" }
  },
  "definitions": {
    "device": {
      "type": "object",
      "additionalProperties": false,
      "properties": {
        "kind": { "enum": ["latched", "held"] },
        "names": { "type": "array", "items": { "type": "string", "minLength": 1, "title": "a state's name" } },
        "takes": { "$ref": "#/definitions/time" }
      }
    },
    "time": {
      "title": "a duration such as `1s`, or {\"min\", \"max\"}",
      "anyOf": [
        { "type": "string" },
        { "type": "object", "required": ["min", "max"], "additionalProperties": false,
          "properties": { "min": { "type": "string" }, "max": { "type": "string" } } },
        { "type": "object", "required": ["mean"], "additionalProperties": false,
          "properties": { "mean": { "type": "string" } } }
      ]
    }
  }
})";

std::string reported(const std::string& text) {
  static const Schema schema(kSchema);
  std::string all;
  for (const Fault& fault : schema.check(nlohmann::json::parse(text))) {
    all += fault.pointer + (fault.at_key ? " (key): " : ": ") + fault.message + "\n";
  }
  return all;
}

TEST_CASE("What fits is told nothing of") {
  CHECK(reported(R"({"version": 1})") == "");
  CHECK(
      reported(
          R"({"version": 1, "count": 2, "devices": {"X": {"kind": "held", "names": ["A"], "takes": {"mean": "1s"}}}})") ==
      "");
}

TEST_CASE("An unknown key is told with the nearest one, or with those known") {
  CHECK(reported(R"({"version": 1, "devises": {}})") ==
        "/devises (key): the key `devises` is unknown here, the nearest is `devices`\n");
  CHECK(reported(R"({"version": 1, "q": {}})") ==
        "/q (key): the key `q` is unknown here, known are `count`, `devices`, `version`\n");
}

TEST_CASE("A missing key is told with what it holds") {
  CHECK(reported("{}") == " (key): the key `version` is missing here, it holds the version of the format, 1\n");
}

TEST_CASE("A number with a point or an exponent is told that it is to be a whole one") {
  CHECK(reported(R"({"version": 1, "count": 1e3})") ==
        "/count: the number `1000.0` stands here, wanted is a count from 1 on, a whole one, written without a point or "
        "exponent\n");
  CHECK(reported(R"({"version": 1, "count": 1.5})") ==
        "/count: the number `1.5` stands here, wanted is a count from 1 on, a whole one, written without a point or "
        "exponent\n");
  CHECK(reported(R"({"version": 1, "count": 0})") ==
        "/count: the number `0` stands here, wanted is a count from 1 on\n");
}

TEST_CASE("A wrong type is told with what is there and what is wanted") {
  CHECK(reported(R"({"version": 1, "count": "2"})") ==
        "/count: the text `2` stands here, wanted is a count from 1 on\n");
  CHECK(reported(R"({"version": 1, "devices": [1]})") == "/devices: an array stands here, wanted is an object\n");
}

TEST_CASE("Bounds, empty texts and other versions are told") {
  CHECK(reported(R"({"version": 1, "count": 0})") ==
        "/count: the number `0` stands here, wanted is a count from 1 on\n");
  CHECK(reported(R"({"version": 1, "devices": {"X": {"names": [""]}}})") ==
        "/devices/X/names/0: an empty text stands here, wanted is a state's name\n");
  CHECK(reported(R"({"version": 2})") ==
        "/version: the number `2` stands here, wanted is the version of the format, 1\n");
}

TEST_CASE("One of several words is told with all and the nearest") {
  CHECK(reported(R"({"version": 1, "devices": {"X/Y": {"kind": "helt"}}})") ==
        "/devices/X~1Y/kind: the text `helt` stands here, wanted is one of `latched`, `held`; the nearest is `held`\n");
}

TEST_CASE("Of several shapes the likeliest is explained") {
  CHECK(reported(R"({"version": 1, "devices": {"X": {"takes": {"min": "1s"}}}})") ==
        "/devices/X/takes (key): the key `max` is missing here\n");
  CHECK(reported(R"({"version": 1, "devices": {"X": {"takes": 5}}})") ==
        "/devices/X/takes: the number `5` stands here, wanted is a duration such as `1s`, or {\"min\", \"max\"}\n");
}

TEST_CASE("Every fault is told at once, up to a hundred") {
  CHECK(reported(R"({"version": 1, "count": 0, "x": 1})").find("count") != std::string::npos);
  nlohmann::json many = {{"version", 1}};
  for (int i = 0; i < 500; ++i) many["devices"]["D" + std::to_string(i)] = {{"kind", 1}};
  CHECK(Schema(kSchema).check(many).size() == 100);
}

TEST_CASE("A keyword that cannot be explained is told in the validator's own words") {
  const Schema schema(R"({"type": "object", "properties": {"a": {"type": "array", "uniqueItems": true}}})");
  const auto faults = schema.check(nlohmann::json::parse(R"({"a": [1, 1]})"));
  REQUIRE(!faults.empty());
  CHECK(faults[0].pointer == "/a");
}

}  // namespace
}  // namespace symplant::json

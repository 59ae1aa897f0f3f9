// Explains in words why a value does not match a schema.
#include "symplant/json/schema.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "support/catch.hpp"
#include "symplant/json/compiled_schema.hpp"

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

TEST_CASE("A valid value gives no message") {
  CHECK(reported(R"({"version": 1})") == "");
  CHECK(
      reported(
          R"({"version": 1, "count": 2, "devices": {"X": {"kind": "held", "names": ["A"], "takes": {"mean": "1s"}}}})") ==
      "");
}

TEST_CASE("An unknown key is reported with the nearest one, or with the known ones") {
  CHECK(reported(R"({"version": 1, "devises": {}})") ==
        "/devises (key): the key `devises` is unknown here; did you mean `devices`?\n");
  CHECK(reported(R"({"version": 1, "q": {}})") ==
        "/q (key): the key `q` is unknown here; the known keys are `count`, `devices`, `version`\n");
}

TEST_CASE("A missing key is reported with its purpose") {
  CHECK(reported("{}") == " (key): the key `version` is missing here; it holds the version of the format, 1\n");
}

TEST_CASE("A number with a point or an exponent is reported as not whole") {
  CHECK(reported(R"({"version": 1, "count": 1e3})") ==
        "/count: expected a count from 1 on, but found the number `1000.0`; write a whole number without a decimal "
        "point or exponent\n");
  CHECK(reported(R"({"version": 1, "count": 1.5})") ==
        "/count: expected a count from 1 on, but found the number `1.5`; write a whole number without a decimal "
        "point or exponent\n");
  CHECK(reported(R"({"version": 1, "count": 0})") == "/count: expected a count from 1 on, but found the number `0`\n");
}

TEST_CASE("A wrong type is reported with the found and the expected type") {
  CHECK(reported(R"({"version": 1, "count": "2"})") == "/count: expected a count from 1 on, but found the text `2`\n");
  CHECK(reported(R"({"version": 1, "devices": [1]})") == "/devices: expected an object, but found an array\n");
}

TEST_CASE("Bounds, empty texts and other versions are reported") {
  CHECK(reported(R"({"version": 1, "count": 0})") == "/count: expected a count from 1 on, but found the number `0`\n");
  CHECK(reported(R"({"version": 1, "devices": {"X": {"names": [""]}}})") ==
        "/devices/X/names/0: expected a state's name, but found an empty text\n");
  CHECK(reported(R"({"version": 2})") == "/version: expected the version of the format, 1, but found the number `2`\n");
}

TEST_CASE("An unknown word is reported with all known words and the nearest") {
  CHECK(reported(R"({"version": 1, "devices": {"X/Y": {"kind": "helt"}}})") ==
        "/devices/X~1Y/kind: expected one of `latched`, `held`, but found the text `helt`; did you mean `held`?\n");
}

TEST_CASE("The likeliest of several shapes is explained") {
  CHECK(reported(R"({"version": 1, "devices": {"X": {"takes": {"min": "1s"}}}})") ==
        "/devices/X/takes (key): the key `max` is missing here\n");
  CHECK(reported(R"({"version": 1, "devices": {"X": {"takes": 5}}})") ==
        "/devices/X/takes: expected a duration such as `1s`, or {\"min\", \"max\"}, but found the number `5`\n");
}

TEST_CASE("Every fault is reported at once, up to a hundred") {
  CHECK(reported(R"({"version": 1, "count": 0, "x": 1})").find("count") != std::string::npos);
  nlohmann::json many = {{"version", 1}};
  for (int i = 0; i < 500; ++i) many["devices"]["D" + std::to_string(i)] = {{"kind", 1}};
  CHECK(Schema(kSchema).check(many).size() == 100);
}

TEST_CASE("A schema accepts what is valid, and only that") {
  const nlohmann::json schema = nlohmann::json::parse(kSchema);
  const CompiledSchema compiled(schema);
  const auto accepted = [&](std::string_view text) { return compiled.fits(nlohmann::json::parse(text)); };
  CHECK(accepted(R"({"version": 1})"));
  CHECK(accepted(R"({"version": 1, "count": 2, "devices": {"X": {"kind": "held", "names": ["A"], "takes": "1s"}}})"));
  CHECK(accepted(R"({"version": 1, "devices": {"X": {"takes": {"mean": "1s"}}}})"));
  for (const std::string_view invalid :
       {"[]", "{}", R"({"version": 2})", R"({"version": 1, "q": 1})", R"({"version": 1, "count": 0})",
        R"({"version": 1, "count": "1"})", R"({"version": 1, "count": 1.5})", R"({"version": 1, "devices": [1]})",
        R"({"version": 1, "devices": {"X": {"kind": "helt"}}})", R"({"version": 1, "devices": {"X": {"names": [""]}}})",
        R"({"version": 1, "devices": {"X": {"takes": {"min": "1s"}}}})"}) {
    CAPTURE(invalid);
    CHECK(!accepted(invalid));
  }
}

TEST_CASE("Equal numbers are equal however they are written, as JSON Schema defines it") {
  const nlohmann::json one = nlohmann::json::parse(R"({"const": 1})");
  CHECK(CompiledSchema(one).fits(nlohmann::json(1.0)));
  CHECK(!CompiledSchema(one).fits(nlohmann::json(true)));
}

TEST_CASE("Lengths count characters, and a schema may refer to itself") {
  const std::string_view text =
      R"({"type": ["array", "string"], "minLength": 2, "maxLength": 3, "maxItems": 1, "items": { "$ref": "#" }})";
  const nlohmann::json schema = nlohmann::json::parse(text);
  const Schema explained(text);
  const auto accepted = [&](const char* value) {
    const bool fits = CompiledSchema(schema).fits(nlohmann::json::parse(value));
    CHECK(explained.check(nlohmann::json::parse(value)).empty() == fits);
    return fits;
  };
  CHECK(accepted(R"([[["ab"]]])"));
  CHECK(accepted(R"(["\u00e4\u00e4\u00e4"])"));
  CHECK(!accepted(R"(["\u00e4"])"));
  CHECK(!accepted(R"(["abcd"])"));
  CHECK(!accepted(R"([["ab", "ab"]])"));
}

TEST_CASE("A schema with keywords that are not supported is refused") {
  const auto refused = [](std::string_view schema) {
    const nlohmann::json text = nlohmann::json::parse(schema);
    try {
      const CompiledSchema compiled(text);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refused(R"({"type": "array", "items": {"uniqueItems": true}})") ==
        "the keyword `uniqueItems` is not supported");
  CHECK(refused(R"({"oneOf": []})") == "the keyword `oneOf` is not supported");
  CHECK(refused(R"({"type": "string", "anyOf": [{"minLength": 1}]})") ==
        "`anyOf` with other keywords is not supported");
}

}  // namespace
}  // namespace symplant::json

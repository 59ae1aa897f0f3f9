// The writer of JSON: the same bytes as the library's.
#include "view/json_writer.hpp"

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "support/catch.hpp"

namespace symplant::test {
namespace {

using nlohmann::ordered_json;
using view::JsonWriter;

/// Writes a document value by value.
void write_json(const ordered_json& json, JsonWriter& writer) {
  switch (json.type()) {
    case ordered_json::value_t::object:
      writer.begin_object();
      for (const auto& [key, value] : json.items()) {
        writer.key(key);
        write_json(value, writer);
      }
      return writer.end_object();
    case ordered_json::value_t::array:
      return writer.array(json, [&](const ordered_json& element) { write_json(element, writer); });
    case ordered_json::value_t::string:
      return writer.value(json.get<std::string>());
    case ordered_json::value_t::boolean:
      return writer.value(json.get<bool>());
    case ordered_json::value_t::number_integer:
      return writer.value(json.get<std::int64_t>());
    case ordered_json::value_t::number_unsigned:
      return writer.value(json.get<std::uint64_t>());
    case ordered_json::value_t::number_float:
      return writer.value(json.get<double>());
    default:
      return writer.null();
  }
}

std::string written(const ordered_json& json, JsonWriter::Form form) {
  return base::text_of([&](base::TextSink& sink) {
    JsonWriter writer(sink, form);
    write_json(json, writer);
    writer.finish();
  });
}

TEST_CASE("A written document has the bytes of nlohmann's") {
  ordered_json document =
      ordered_json::parse(R"({"empty": {}, "none": [], "deep": [[1, [2, []]], {"a": {"b": [null, true, false]}}],
    "texts": ["", "plain", "quote \" and \\", "line\n\t\r", "\u0001\u001f\u007f", "\u00e9\u4e2d\ud83d\ude00\u2028"],
    "key \"\n": -1, "numbers": [0, -1, 0.1, 1.0, -0.0, 1e300, 5e-324]})");
  document["limits"] = {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::uint64_t>::max()};
  document["invalid"] =
      "a\xFF"
      "b\xE4\xB8";
  document["long"] = std::string(200'000, 'x');
  for (const ordered_json& json :
       {document, ordered_json::object(), ordered_json::array(), ordered_json("text"), ordered_json(7)}) {
    CHECK(written(json, JsonWriter::Form::indented) ==
          json.dump(2, ' ', false, ordered_json::error_handler_t::replace));
    CHECK(written(json, JsonWriter::Form::compact) ==
          json.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  }
}

TEST_CASE("Rows and members are values like others") {
  const std::string text = base::text_of([](base::TextSink& sink) {
    JsonWriter json(sink, JsonWriter::Form::compact);
    json.begin_object();
    json.member("a", std::uint8_t{255});
    json.member("b", "text");
    json.key("c");
    json.row(1, true, "x", std::string("y"));
    json.key("d");
    json.literal(R"({"made": 1})");
    json.end_object();
    json.finish();
  });
  CHECK(text == R"({"a":255,"b":"text","c":[1,true,"x","y"],"d":{"made": 1}})");
}

}  // namespace
}  // namespace symplant::test

// Writes a JSON document part by part, so that it is never whole in memory.
#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "base/text_source.hpp"

namespace symplant::view {

/// Writes values in the order of the calls. The caller closes what it opens, and gives each member of an object a key.
/// The text equals that of nlohmann::ordered_json::dump(), in which an invalid byte becomes U+FFFD.
class JsonWriter {
 public:
  enum class Form : std::uint8_t {
    indented,  ///< each value on a line, two blanks for each level
    compact,   ///< without blanks and line ends
  };
  JsonWriter(base::TextSink& sink, Form form) : out_(sink), indented_(form == Form::indented) {}

  void begin_object() { begin('{'); }
  void end_object() { end('}'); }
  void begin_array() { begin('['); }
  void end_array() { end(']'); }
  /// The key of the next value, which belongs to the open object.
  void key(std::string_view name);

  void value(std::string_view text);
  void value(double number);
  template <std::integral Number>
  void value(Number number) {
    if constexpr (std::same_as<Number, bool>) {
      literal(number ? "true" : "false");
    } else {
      char digits[24];
      literal({digits, static_cast<std::size_t>(std::to_chars(digits, digits + sizeof digits, number).ptr - digits)});
    }
  }
  void null() { literal("null"); }
  /// A value that is already JSON and has no line ends.
  void literal(std::string_view json);

  template <typename Value>
  void member(std::string_view name, const Value& content) {
    key(name);
    value(content);
  }
  /// An array of all elements of a range, each written by `write`.
  template <typename Range, typename Write>
  void array(const Range& range, Write write) {
    begin_array();
    for (const auto& element : range) write(element);
    end_array();
  }
  /// An array of some values, of different types.
  template <typename... Values>
  void row(const Values&... values) {
    begin_array();
    (value(values), ...);
    end_array();
  }

  /// Passes the rest to the sink. Call after the last value.
  void finish() { out_.finish(); }

 private:
  void begin(char bracket);
  void end(char bracket);
  /// What separates a value or a key from the text before it.
  void separate();
  void new_line();
  void quoted(std::string_view text);

  base::PartCollector out_;
  const bool indented_;
  std::size_t depth_ = 0;
  bool first_ = true;   ///< nothing is in the open object or array
  bool keyed_ = false;  ///< a key was written, its value follows
};

}  // namespace symplant::view

// Where in a JSON text a value stands.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace symplant::json {

/// What is wrong with a value, by its JSON pointer (RFC 6901).
struct Fault {
  std::string pointer;
  std::string message;
  std::size_t column = 0;  ///< within the value's text (that of a condition, say), in bytes from 0
  bool at_key = false;     ///< the value's key is at fault, not the value
};

/// Bytes of the text: [begin, end).
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
  friend bool operator==(const Span&, const Span&) = default;
};

struct Related {
  Span span;
  std::string message;
};

/// What is wrong, by bytes of the text.
struct Placed {
  Span span;
  std::string message;
  std::optional<Related> related;
};

/// The span of each pointer's value: of a text, number, truth value or null its own; of an object or array that of its
/// key, or of its opening bracket where it has none. With `at_key` the key's, where there is one. Where a pointer leads
/// nowhere, the span of the nearest value above it. One pass over the text, which must have been parsed without a fault
/// of syntax. O(text + pointers).
std::vector<Span> spans(std::string_view text, std::span<const Fault> faults);

/// The faults with their spans. `column` is counted in the value's decoded text, and found again behind escapes.
std::vector<Placed> locate(std::string_view text, std::span<const Fault> faults);

struct LineColumn {
  std::size_t line;    ///< from 1
  std::size_t column;  ///< from 1, in code points
};
/// O(byte). A byte behind the end is taken as the end.
LineColumn line_and_column(std::string_view text, std::size_t byte);

/// "/a~1b" from "" and "a/b".
std::string child(std::string_view pointer, std::string_view key);
std::string child(std::string_view pointer, std::size_t index);

}  // namespace symplant::json

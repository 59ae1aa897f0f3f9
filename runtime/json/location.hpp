// Locates values in a JSON text.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace symplant::json {

/// A fault of a value, by its JSON pointer (RFC 6901).
struct Fault {
  std::string pointer;
  std::string message;
  std::size_t column = 0;  ///< within the value's text (such as a condition), in bytes from 0
  bool at_key = false;     ///< the value's key is at fault, not the value
};

/// A range of bytes of the text: [begin, end).
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
  friend bool operator==(const Span&, const Span&) = default;
};

struct Related {
  Span span;
  std::string message;
};

/// A fault, by bytes of the text.
struct Placed {
  Span span;
  std::string message;
  std::optional<Related> related;
};

/// The span of each pointer's value: for a text, number, boolean or null its own; for an object or array that of its
/// key, or of its opening bracket if it has no key. With `at_key` that of the key, if there is one. If a pointer refers
/// to no value, the span of the nearest parent. The text must have valid syntax. One pass; O(text + pointers).
std::vector<Span> spans(std::string_view text, std::span<const Fault> faults);

/// The faults with their spans. Fault::column counts bytes of the decoded text; escapes are taken into account.
std::vector<Placed> locate(std::string_view text, std::span<const Fault> faults);

struct LineColumn {
  std::size_t line;    ///< from 1
  std::size_t column;  ///< from 1, in code points
};
/// O(byte). A byte after the end counts as the end.
LineColumn line_and_column(std::string_view text, std::size_t byte);

/// "/a~1b" from "" and "a/b".
std::string child(std::string_view pointer, std::string_view key);
std::string child(std::string_view pointer, std::size_t index);

}  // namespace symplant::json

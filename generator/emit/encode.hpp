// Encoders for a user's text in generated code, one for each context; the result is ASCII. No other code inserts it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace symplant::emit {

/// For the inside of a `//` comment: printable ASCII. Every other character, every backslash and the second of two `?`
/// (`?\?/` at the end of a line is a trigraph of a backslash) becomes <U+XXXX>: no comment can extend to the next line.
std::string comment_text(std::string_view utf8);

/// A C++ string literal with its quotes: octal escapes of three digits, never `\x`, no trigraph.
std::string string_literal(std::string_view bytes);
/// Appends the inside of a string literal, without quotes.
void append_literal(std::string& out, std::string_view bytes);
void append_comment(std::string& out, std::string_view utf8);

/// How many of the first bytes of a text surely need no encoding in a comment, and in a literal.
std::size_t plain_in_comment(std::string_view utf8);
std::size_t plain_in_literal(std::string_view bytes);

}  // namespace symplant::emit

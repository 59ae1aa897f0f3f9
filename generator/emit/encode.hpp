// The only ways in which a user's text gets into generated code: one encoder a context. All give printable ASCII.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace symplant::emit {

/// For the inside of a `//` comment: printable ASCII, every other character, every backslash and the second of two `?`
/// (`?\?/` at a line's end is a trigraph of a backslash) as <U+XXXX>, so that no comment can swallow the next line.
std::string comment_text(std::string_view utf8);

/// A C++ string literal with its quotes: octal escapes of three digits, never `\x`, no trigraph.
std::string string_literal(std::string_view bytes);
/// Appends the inside of one, without quotes.
void append_literal(std::string& out, std::string_view bytes);
void append_comment(std::string& out, std::string_view utf8);

/// How many of the first bytes of a text stand for themselves in a comment, and in a literal. There may be more.
std::size_t plain_in_comment(std::string_view utf8);
std::size_t plain_in_literal(std::string_view bytes);

}  // namespace symplant::emit

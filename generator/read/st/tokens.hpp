// Splits Structured Text into tokens, as far as declarations need it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "text/source_file.hpp"

namespace symplant::read::st {

enum class Kind : std::uint8_t {
  end,
  word,      ///< letters, digits and `_`
  quoted,    ///< 'text', "name" or `name`
  unclosed,  ///< a quoted text up to the line's end, without a closing quote
  comment,   ///< of any of the three kinds, delimiters included
  pragma,    ///< {...}, with texts in quotes
  mark,      ///< any other character
};

struct Token {
  Kind kind = Kind::end;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Reads token by token, without blanks. Needs no stack, however deep comments are nested. O(text) over all tokens.
class Tokens {
 public:
  Tokens(std::string_view text, text::Span range) : text_(text.substr(0, range.end)), at_(range.begin) {}

  Token next();
  /// The next token that is neither a comment nor a pragma.
  Token next_of_code();

  /// Up to the end of the range.
  std::string_view text() const { return text_; }
  std::string_view text_of(const Token& token) const { return text_.substr(token.begin, token.end - token.begin); }
  bool is_mark(const Token& token, char mark) const { return token.kind == Kind::mark && text_[token.begin] == mark; }
  bool is_word(const Token& token, std::string_view word) const;

  std::size_t offset() const { return at_; }
  /// Continues at an offset. Going back over a text keeps what is known about its comments and pragmas.
  void go_to(std::size_t offset) { at_ = offset; }

  /// The offset of the first comment that is not closed.
  std::optional<std::size_t> unclosed_comment() const { return unclosed_comment_; }

 private:
  char at(std::size_t offset) const { return offset < text_.size() ? text_[offset] : '\0'; }
  std::size_t word_end() const;
  Token quoted(char quote) const;
  std::size_t nested_comment_end();
  std::size_t closed_by(std::string_view closing);
  std::size_t line_end() const;
  std::size_t pragma_end();

  std::string_view text_;
  std::size_t at_;
  std::optional<std::size_t> unclosed_comment_;
  bool comments_nest_ = true;  ///< false after a comment that would not be closed with nesting
  bool pragmas_quote_ = true;  ///< false after a pragma that would not be closed with quotes
  bool pragmas_end_ = true;    ///< false if no `}` follows
};

}  // namespace symplant::read::st

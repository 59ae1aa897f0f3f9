// Splits Structured Text into tokens.
#include "read/st/tokens.hpp"

#include <algorithm>
#include <array>

#include "text/ascii.hpp"

namespace symplant::read::st {

namespace {

constexpr std::size_t kNothing = std::string_view::npos;

constexpr auto kOfWord = [] {
  std::array<bool, 256> of_word{};
  for (unsigned c = '0'; c <= '9'; ++c) of_word[c] = true;
  for (unsigned c = 'A'; c <= 'Z'; ++c) of_word[c] = of_word[c | 0x20U] = true;
  for (unsigned c = 0x80; c <= 0xFF; ++c) of_word[c] = true;
  of_word['_'] = true;
  return of_word;
}();

bool is_of_word(char c) { return kOfWord[static_cast<unsigned char>(c)]; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }

}  // namespace

bool Tokens::is_word(const Token& token, std::string_view word) const {
  return token.kind == Kind::word && text::equal_ignoring_case(text_of(token), word);
}

Token Tokens::next() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  Token token{Kind::mark, at_, at_ + 1};
  const char first = at(at_);
  const char second = at(at_ + 1);
  if (at_ >= text_.size()) {
    token = {Kind::end, text_.size(), text_.size()};
  } else if (is_of_word(first)) {
    token = {Kind::word, at_, word_end()};
  } else if (first == '(' && second == '*') {
    token = {Kind::comment, at_, nested_comment_end()};
  } else if (first == '/' && second == '*') {
    token = {Kind::comment, at_, closed_by("*/")};
  } else if (first == '/' && second == '/') {
    token = {Kind::comment, at_, line_end()};
  } else if (first == '\'' || first == '"' || first == '`') {
    token = quoted(first);
  } else if (first == '{') {
    token.end = pragma_end();
    if (token.end != at_ + 1) token.kind = Kind::pragma;
  }
  at_ = token.end;
  return token;
}

Token Tokens::next_of_code() {
  Token token = next();
  while (token.kind == Kind::comment || token.kind == Kind::pragma) token = next();
  return token;
}

std::size_t Tokens::word_end() const {
  std::size_t end = at_;
  while (end < text_.size() && is_of_word(text_[end])) ++end;
  return end;
}

std::size_t Tokens::line_end() const { return std::min(text_.find_first_of("\r\n", at_), text_.size()); }

Token Tokens::quoted(char quote) const {
  std::size_t end = at_ + 1;
  for (; end < text_.size() && text_[end] != '\n' && text_[end] != '\r'; ++end) {
    if (text_[end] == quote) return {Kind::quoted, at_, end + 1};
    if (text_[end] == '$' && quote != '`' && at(end + 1) != '\n' && at(end + 1) != '\r') ++end;
  }
  return {Kind::unclosed, at_, std::min(end, text_.size())};
}

/// The end of the comment at `at_`, which the first `closing` ends.
std::size_t Tokens::closed_by(std::string_view closing) {
  const std::size_t end = text_.find(closing, at_ + 2);
  if (end != kNothing) return end + closing.size();
  if (!unclosed_comment_) unclosed_comment_ = at_;
  return text_.size();
}

std::size_t Tokens::nested_comment_end() {
  constexpr std::string_view kClosing = "*)";
  if (!comments_nest_) return closed_by(kClosing);
  std::size_t depth = 1;
  std::size_t next = at_ + 2;
  for (std::size_t star = text_.find('*', next); star != kNothing; star = text_.find('*', next)) {
    const bool opens = star > next && text_[star - 1] == '(';
    next = star + 1;
    if (opens) {
      ++depth;
    } else if (at(next) == ')') {
      ++next;
      if (--depth == 0) return next;
    }
  }
  comments_nest_ = false;
  unclosed_comment_ = unclosed_comment_.value_or(at_);
  return closed_by(kClosing);
}

/// The end of the pragma at `at_`; the next character if it is not closed.
std::size_t Tokens::pragma_end() {
  if (!pragmas_end_) return at_ + 1;
  for (std::size_t end = at_ + 1; pragmas_quote_ && end < text_.size(); ++end) {
    if (text_[end] == '}') return end + 1;
    if (text_[end] != '\'') continue;
    end = text_.find('\'', end + 1);
    if (end == kNothing) break;
  }
  pragmas_quote_ = false;
  const std::size_t end = text_.find('}', at_);
  if (end != kNothing) return end + 1;
  pragmas_end_ = false;
  return at_ + 1;
}

}  // namespace symplant::read::st

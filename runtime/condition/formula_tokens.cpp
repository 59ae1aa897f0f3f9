// Divides formulas into tokens, and reads their numbers.
#include "symplant/condition/formula_tokens.hpp"

#include <charconv>
#include <string>
#include <system_error>

#include "symplant/tables/ascii.hpp"

namespace symplant::condition {
namespace {

using tables::is_digit;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool is_letter(char c) {
  return static_cast<unsigned char>(c) >= 0x80 || c == '_' || (tables::upper(c) >= 'A' && tables::upper(c) <= 'Z');
}

/// The end of a name in quotes, or npos.
std::size_t end_of_quotes(std::string_view text, std::size_t at) {
  for (++at; at < text.size(); ++at) {
    if (text[at] != '\'') continue;
    if (at + 1 == text.size() || text[at + 1] != '\'') return at + 1;
    ++at;
  }
  return std::string_view::npos;
}

}  // namespace

/// All that may be intended as a number.
std::size_t Tokens::end_of_number(std::size_t at) const {
  while (at < text_.size()) {
    const bool is_sign = text_[at] == '+' || text_[at] == '-';
    const bool in_exponent =
        is_sign && tables::upper(text_[at - 1]) == 'E' && at + 1 < text_.size() && is_digit(text_[at + 1]);
    if (!in_exponent && !is_digit(text_[at]) && !is_letter(text_[at]) && text_[at] != '.' && text_[at] != '#') break;
    ++at;
  }
  return at;
}

Token Tokens::next(bool digits_begin_names) {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  const std::size_t begin = at_;
  if (begin == text_.size()) return {Token::Kind::end, {}, begin};
  const char first = text_[begin];
  Token::Kind kind = Token::Kind::sign;
  if (first == '\'') {
    at_ = end_of_quotes(text_, begin);
    kind = at_ == std::string_view::npos ? Token::Kind::unclosed : Token::Kind::quoted;
    if (kind == Token::Kind::unclosed) at_ = begin + 1;
  } else if (is_digit(first) && !digits_begin_names) {
    at_ = end_of_number(begin);
    kind = Token::Kind::number;
  } else if (is_digit(first) || is_letter(first)) {
    while (at_ < text_.size() && (is_digit(text_[at_]) || is_letter(text_[at_]))) ++at_;
    kind = Token::Kind::name;
  } else {
    ++at_;
    if ((first == '<' || first == '>') && at_ < text_.size() && text_[at_] == '=') ++at_;
  }
  return {kind, text_.substr(begin, at_ - begin), begin};
}

Name name_of(const Token& token) {
  if (token.kind != Token::Kind::quoted) return {std::string(token.text), token.index()};
  std::string text;
  for (std::size_t i = 1; i + 1 < token.text.size(); ++i) {
    text += token.text[i];
    if (token.text[i] == '\'') ++i;
  }
  return {std::move(text), token.index()};
}

std::variant<double, Fault> read_double(const Token& token) {
  const std::string ticked = "`" + std::string(token.text) + "`";
  const char* end = token.text.data() + token.text.size();
  double number = 0;
  const auto [stop, error] = std::from_chars(token.text.data(), end, number);
  const std::size_t dot = token.text.find('.');
  const bool bare_dot =
      dot != std::string_view::npos && (dot + 1 == token.text.size() || !is_digit(token.text[dot + 1]));
  if (error == std::errc::invalid_argument || stop != end || bare_dot) {
    return Fault{token.index(), ticked + " is not a number; write it as in `12`, `0.5` or `1e-3`, and a name that " +
                                    "begins with a digit in single quotes"};
  }
  if (error != std::errc{}) return Fault{token.index(), "the number " + ticked + " is out of the range of a double"};
  return number;
}

}  // namespace symplant::condition

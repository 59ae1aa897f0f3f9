// Splits formulas and conditions into tokens.
#include "support/reference/formula_text.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "support/reference/rules.hpp"

namespace symplant::reference {
namespace {

bool is_digit_char(char c) { return c >= '0' && c <= '9'; }
bool is_name_char(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || c == '_' || std::isalnum(byte) != 0;
}

std::size_t digits_end(std::string_view text, std::size_t at) {
  while (at < text.size() && (is_digit_char(text[at]) || text[at] == '_')) ++at;
  return at;
}

/// Where the number that begins there ends.
std::size_t number_end(std::string_view text, std::size_t begin) {
  std::size_t at = digits_end(text, begin);
  if (at < text.size() && text[at] == '#') {
    ++at;
    while (at < text.size() && is_name_char(text[at])) ++at;
    return at;
  }
  if (at + 1 < text.size() && text[at] == '.' && is_digit_char(text[at + 1])) at = digits_end(text, at + 1);
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t exponent = at + 1;
    if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
    if (exponent < text.size() && is_digit_char(text[exponent])) at = digits_end(text, exponent);
  }
  return at;
}

Token quoted(std::string_view text, std::size_t& at) {
  Token token{Token::Kind::quoted, {}};
  for (++at; at < text.size(); ++at) {
    if (text[at] != '\'') {
      token.text += text[at];
    } else if (at + 1 < text.size() && text[at + 1] == '\'') {
      token.text += text[at++];
    } else {
      ++at;
      return token;
    }
  }
  throw std::runtime_error("a quote is not closed");
}

Token name_or_number(std::string_view text, std::size_t& at) {
  const std::size_t begin = at;
  if (is_digit_char(text[at])) {
    at = number_end(text, begin);
    const bool ends = at == text.size() || !is_name_char(text[at]);
    if (ends) return {Token::Kind::number, std::string(text.substr(begin, at - begin))};
    at = begin;
  }
  while (at < text.size() && is_name_char(text[at])) ++at;
  return {Token::Kind::name, std::string(text.substr(begin, at - begin))};
}

Token sign(std::string_view text, std::size_t& at) {
  for (const std::string_view two : {"<=", ">="}) {
    if (text.substr(at, 2) != two) continue;
    at += 2;
    return {Token::Kind::sign, std::string(two)};
  }
  const std::string one(text.substr(at++, 1));
  if (std::string_view("<>=+-*/(),.[]").find(one) == std::string_view::npos) throw std::runtime_error("`" + one + "`");
  return {Token::Kind::sign, one};
}

}  // namespace

Tokens::Tokens(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    if (std::isspace(static_cast<unsigned char>(text[at])) != 0) {
      ++at;
    } else if (text[at] == '\'') {
      all_.push_back(quoted(text, at));
    } else if (is_name_char(text[at])) {
      all_.push_back(name_or_number(text, at));
    } else {
      all_.push_back(sign(text, at));
    }
  }
  all_.emplace_back();
}

bool Tokens::is_word(std::string_view word, bool any_case) const {
  if (next().kind != Token::Kind::name) return false;
  return any_case ? same_name(next().text, word) : next().text == word;
}

bool Tokens::is_sign_after_next(std::string_view sign) const {
  const Token& after = all_[std::min(at_ + 1, all_.size() - 1)];
  return after.kind == Token::Kind::sign && after.text == sign;
}

bool Tokens::accept_sign(std::string_view sign) {
  const bool there = is_sign(sign);
  if (there) take();
  return there;
}

bool Tokens::accept_word(std::string_view word, bool any_case) {
  const bool there = is_word(word, any_case);
  if (there) take();
  return there;
}

void Tokens::expect_sign(std::string_view sign) {
  if (!accept_sign(sign)) throw std::runtime_error("`" + std::string(sign) + "` expected before `" + next().text + "`");
}

void Tokens::expect_end() const {
  if (!at_end()) throw std::runtime_error("the end expected before `" + next().text + "`");
}

DottedName Tokens::dotted_name() {
  DottedName name;
  do {
    // After a dot, digits are a name too.
    if (!is_name() && (name.names.empty() || next().kind != Token::Kind::number)) {
      throw std::runtime_error("a name expected before `" + next().text + "`");
    }
    name.names.push_back(take().text);
  } while (accept_sign("."));
  if (accept_sign("[")) {
    if (next().kind != Token::Kind::number) throw std::runtime_error("a number expected in `[]`");
    name.index = static_cast<std::uint32_t>(std::stoul(take().text));
    if (name.index == 0) throw std::runtime_error("outputs are numbered from 1");
    expect_sign("]");
  }
  return name;
}

double double_of(const std::string& text) {
  std::string digits;
  std::copy_if(text.begin(), text.end(), std::back_inserter(digits), [](char c) { return c != '_'; });
  const std::size_t mark = digits.find('#');
  if (mark != std::string::npos) {
    return static_cast<double>(std::stoull(digits.substr(mark + 1), nullptr, std::stoi(digits.substr(0, mark))));
  }
  return std::strtod(digits.c_str(), nullptr);
}

}  // namespace symplant::reference

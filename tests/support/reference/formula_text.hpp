// The tokens of formulas, and of conditions that compare two operands.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "support/reference/formula.hpp"

namespace symplant::reference {

struct Token {
  enum class Kind : unsigned char { number, name, quoted, sign, end };
  Kind kind = Kind::end;
  std::string text = {};  ///< of `quoted`: without the quotes
};

/// Reads a text token by token. Throws std::runtime_error where it is wrong.
class Tokens {
 public:
  explicit Tokens(std::string_view text);

  const Token& next() const { return all_[at_]; }
  Token take() { return all_[at_ + 1 < all_.size() ? at_++ : at_]; }
  bool at_end() const { return next().kind == Token::Kind::end; }
  bool is_sign(std::string_view sign) const { return next().kind == Token::Kind::sign && next().text == sign; }
  bool is_name() const { return next().kind == Token::Kind::name || next().kind == Token::Kind::quoted; }
  /// The word, in any case of its letters if `any_case`.
  bool is_word(std::string_view word, bool any_case = false) const;
  /// Whether the token after the next one is a sign.
  bool is_sign_after_next(std::string_view sign) const;

  bool accept_sign(std::string_view sign);
  bool accept_word(std::string_view word, bool any_case = false);
  void expect_sign(std::string_view sign);
  void expect_end() const;
  DottedName dotted_name();

 private:
  std::vector<Token> all_;  ///< the last one is the end
  std::size_t at_ = 0;
};

/// The double nearest to a number. Also reads `16#FF`, `8#17`, `2#101` and `1_000`.
double double_of(const std::string& text);

}  // namespace symplant::reference

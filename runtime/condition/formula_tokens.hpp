// Divides a formula into tokens.
#pragma once

#include <cstddef>
#include <string_view>
#include <variant>

#include "symplant/condition/expression.hpp"

namespace symplant::condition {

struct Token {
  enum class Kind : unsigned char {
    end,
    number,    ///< what begins with a digit: read_double() decides
    name,      ///< without quotes
    quoted,    ///< a name in quotes, which are in `text`
    unclosed,  ///< a quote without an end
    sign,      ///< `<=`, `>=`, or any other character
  };
  Kind kind = Kind::end;
  std::string_view text;
  std::size_t offset = 0;

  Location index() const { return {offset, text.size()}; }
  bool is_sign(std::string_view sign) const { return kind == Kind::sign && text == sign; }
  bool is_name(std::string_view name) const { return kind == Kind::name && text == name; }
};

/// The tokens of a text, one after the other. Bytes of other alphabets are letters. `text` must outlive this object.
class Tokens {
 public:
  explicit Tokens(std::string_view text) : text_(text) {}

  /// O(token). `digits_begin_names`: after a dot or a bracket, where there is no number.
  Token next(bool digits_begin_names);

 private:
  std::size_t end_of_number(std::size_t at) const;

  std::string_view text_;
  std::size_t at_ = 0;
};

/// The name of a token of kind `name` or `quoted`, in which a doubled quote is one.
Name name_of(const Token& token);

/// The nearest double to a decimal number, or what is wrong with it. O(text).
std::variant<double, Fault> read_double(const Token& token);

}  // namespace symplant::condition

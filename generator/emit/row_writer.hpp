// Rows as text: the one way in which tables get into generated code.
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "emit/encode.hpp"

namespace symplant::emit {

/// Puts rows together, a line each. What a user wrote goes in by comment() and literal() alone.
class RowWriter {
 public:
  RowWriter& text(std::string_view text) {
    out_.append(text);
    return *this;
  }
  template <std::integral Number>
  RowWriter& number(Number value) {
    std::array<char, 24> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    out_.append(digits.data(), end);
    return *this;
  }
  /// `0x1F`
  RowWriter& hex(std::uint64_t value) {
    std::array<char, 24> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, 16).ptr;
    out_.append("0x").append(digits.data(), end);
    return *this;
  }
  /// Numbers with commas between.
  template <std::integral First, std::integral... Rest>
  RowWriter& numbers(First first, Rest... rest) {
    number(first);
    (text(", ").number(rest), ...);
    return *this;
  }
  RowWriter& comment(std::string_view utf8) {
    append_comment(out_, utf8);
    return *this;
  }
  RowWriter& literal(std::string_view bytes) {
    append_literal(out_, bytes);
    return *this;
  }

  /// All rows without the last one's line end.
  std::string take() {
    if (!out_.empty()) out_.pop_back();
    return std::move(out_);
  }
  std::string take_or(std::string_view none) { return out_.empty() ? std::string(none) : take(); }

 private:
  std::string out_;
};

}  // namespace symplant::emit

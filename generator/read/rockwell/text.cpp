// Decodes the escapes in texts of Logix exports.
#include "read/rockwell/text.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>

#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::read {

namespace {

constexpr std::size_t kUnitDigits = 4;

/// The UTF-16 unit of `$XXXX` at `at`.
std::optional<char32_t> unit_at(std::string_view text, std::size_t at) {
  if (at + 1 + kUnitDigits > text.size() || text[at] != '$') return std::nullopt;
  const char* const begin = text.data() + at + 1;
  unsigned value = 0;
  const auto [end, fault] = std::from_chars(begin, begin + kUnitDigits, value, 16);
  if (fault != std::errc() || end != begin + kUnitDigits) return std::nullopt;
  return static_cast<char32_t>(value);
}

bool is_high_surrogate(char32_t unit) { return unit >= 0xD800 && unit <= 0xDBFF; }
bool is_low_surrogate(char32_t unit) { return unit >= 0xDC00 && unit <= 0xDFFF; }

class RockwellTextDecoder {
 public:
  explicit RockwellTextDecoder(std::string_view text) : text_(text) { result_.reserve(text.size()); }

  std::string decode() {
    while (at_ < text_.size()) {
      const std::size_t dollar = std::min(text_.find('$', at_), text_.size());
      result_.append(text_, at_, dollar - at_);
      at_ = dollar;
      if (at_ < text_.size()) take_escape();
    }
    const std::size_t begin = result_.find_first_not_of(kBlanks);
    if (begin == std::string::npos) return {};
    result_.erase(result_.find_last_not_of(kBlanks) + 1);
    result_.erase(0, begin);
    return std::move(result_);
  }

 private:
  static constexpr const char* kBlanks = " \t\n";

  void take_escape() {
    if (const auto unit = unit_at(text_, at_)) return take_unit(*unit);
    const char letter = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
    switch (text::upper(letter)) {
      case 'N':
      case 'P':
        return take(2, '\n');
      case 'L':
        return take_line_feed();
      case 'R':
        after_return_ = result_.size() + 1;
        return take(2, '\n');
      case 'T':
        return take(2, '\t');
      case 'Q':
        return take(2, '"');
      case '$':
      case '\'':
      case '"':
        return take(2, letter);
      default:
        return take(1, '$');
    }
  }

  void take(std::size_t length, char c) {
    at_ += length;
    result_ += c;
  }

  void take_line_feed() {
    if (result_.size() != after_return_) return take(2, '\n');
    at_ += 2;
    after_return_ = std::string::npos;
  }

  void take_unit(char32_t unit) {
    at_ += 1 + kUnitDigits;
    if (is_high_surrogate(unit)) {
      const auto low = unit_at(text_, at_);
      if (low && is_low_surrogate(*low)) {
        at_ += 1 + kUnitDigits;
        return text::append_utf8(result_, 0x10000 + ((unit - 0xD800) << 10U) + (*low - 0xDC00));
      }
    }
    if (is_high_surrogate(unit) || is_low_surrogate(unit)) unit = text::kReplacementCharacter;
    if (unit == '\r') unit = '\n';
    const bool control = (unit < 0x20 && unit != '\t' && unit != '\n') || (unit >= 0x7F && unit < 0xA0);
    text::append_utf8(result_, control ? U' ' : unit);
  }

  std::string_view text_;
  std::string result_;
  std::size_t at_ = 0;
  std::size_t after_return_ = std::string::npos;  ///< the length of `result_` directly after a `$R`
};

}  // namespace

std::string decode_rockwell_text(std::string_view text) { return RockwellTextDecoder(text).decode(); }

}  // namespace symplant::read

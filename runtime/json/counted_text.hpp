// An input iterator for nlohmann's reader that counts the bytes read.
#pragma once

#include <cstddef>
#include <iterator>
#include <string_view>

namespace symplant::json {

/// An input iterator that counts in `taken` the bytes read. At the end of a number the reader has already read the byte
/// after it.
class CountedText {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountedText(const char* at, std::size_t* taken) : at_(at), taken_(taken) {}

  reference operator*() const { return *at_; }
  CountedText& operator++() {
    ++at_;
    ++*taken_;
    return *this;
  }
  CountedText operator++(int) {
    CountedText before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const CountedText& a, const CountedText& b) { return a.at_ == b.at_; }
  friend bool operator!=(const CountedText& a, const CountedText& b) { return a.at_ != b.at_; }

 private:
  const char* at_;
  std::size_t* taken_;
};

/// The offset of the opening quote of a string literal; `end` is the offset after its closing quote.
inline std::size_t opening_quote(std::string_view text, std::size_t end) {
  std::size_t at = end - 1;
  while (at > 0) {
    --at;
    if (text[at] != '"') continue;
    std::size_t backslashes = 0;
    while (backslashes < at && text[at - 1 - backslashes] == '\\') ++backslashes;
    if (backslashes % 2 == 0) break;
  }
  return at;
}

}  // namespace symplant::json

// Searches a text from beginning to end, 64 bytes at a time.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/words.hpp"

namespace symplant::base {

/// Finds the next of three characters. Examines each byte once, however close to each other the results are, as long as
/// `from` is not before the last result.
class ForwardSearch {
 public:
  ForwardSearch(std::string_view text, char a, char b, char c) : text_(text), a_(a), b_(b), c_(c) {}

  /// The first offset, from `from` on, of one of the characters; the text's size if there is none.
  std::size_t next(std::size_t from) {
    for (;;) {
      if (from - begin_ >= end_ - begin_) {  // also if it is before the block
        if (from >= text_.size()) return text_.size();
        examine(from);
      }
      const std::uint64_t left = found_ >> (from - begin_);
      if (left != 0) return from + static_cast<std::size_t>(std::countr_zero(left));
      from = end_;
    }
  }

 private:
  static constexpr std::size_t kBlock = 64;

  /// Fills `found_` for the bytes from an offset on.
  [[gnu::noinline]] void examine(std::size_t begin) {
    begin_ = begin;
    end_ = std::min(begin + kBlock, text_.size());
    found_ = 0;
    const char* const bytes = text_.data() + begin;
    if (end_ - begin_ < kBlock) {
      for (std::size_t i = 0; i < end_ - begin_; ++i) found_ |= std::uint64_t{is_searched(bytes[i])} << i;
      return;
    }
    std::array<char, kBlock> flags{};  // 0 or 1: the compiler makes them 16 at a time
    for (std::size_t i = 0; i < kBlock; ++i) flags[i] = is_searched(bytes[i]) ? 1 : 0;
    constexpr std::uint64_t kGather = 0x0102'0408'1020'4080;  // byte i of a word to bit 56 + i
    for (std::size_t i = 0; i < kBlock; i += 8) found_ |= (load_word(flags.data() + i) * kGather >> 56U) << i;
  }

  bool is_searched(char c) const { return (c == a_) | (c == b_) | (c == c_); }

  std::string_view text_;
  char a_;
  char b_;
  char c_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;      ///< the bytes before it are examined
  std::uint64_t found_ = 0;  ///< bit i: the byte at begin_ + i is one of the characters
};

}  // namespace symplant::base

// Line numbers of offsets that do not decrease.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace symplant::read {

/// Counts the lines of a text in one pass. Lines end at LF, CRLF or CR.
class LineCounter {
 public:
  explicit LineCounter(std::string_view text) : text_(text), has_return_(text.find('\r') != std::string_view::npos) {}

  /// The line of an offset, counted from 1. Offsets must not decrease from call to call. O(text) over all calls.
  std::uint32_t line_at(std::size_t offset) {
    offset = std::min(offset, text_.size());
    if (offset <= at_) return line_;
    const std::string_view passed = text_.substr(at_, offset - at_);
    line_ += static_cast<std::uint32_t>(std::count(passed.begin(), passed.end(), '\n'));
    if (has_return_) line_ += lone_returns(offset);
    at_ = offset;
    return line_;
  }

 private:
  std::uint32_t lone_returns(std::size_t end) const {
    std::uint32_t count = 0;
    for (std::size_t i = at_; i < end; ++i) {
      if (text_[i] == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n')) ++count;
    }
    return count;
  }

  std::string_view text_;
  bool has_return_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1;
};

}  // namespace symplant::read

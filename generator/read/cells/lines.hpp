// The lines of a text, as views into it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/words.hpp"
#include "text/source_file.hpp"

namespace symplant::read {

struct Line {
  std::string_view text;     ///< without its line end
  std::size_t begin = 0;     ///< its offset
  std::uint32_t number = 0;  ///< counted from 1

  text::Span span() const { return {begin, begin + text.size()}; }
};

/// Reads line by line. Lines end at LF, CRLF or CR. O(text) over all lines.
class LineReader {
 public:
  explicit LineReader(std::string_view text, std::size_t offset = 0, std::uint32_t number = 1)
      : text_(text), at_(offset), number_(number) {}

  /// False at the end. There is no line after the last line end.
  bool next(Line& line) {
    if (at_ >= text_.size()) return false;
    const std::size_t end = base::find_any(text_, at_, '\n', '\r', '\n');
    line = {text_.substr(at_, end - at_), at_, number_++};
    at_ = end;
    if (at_ < text_.size()) at_ += text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n' ? 2U : 1U;
    return true;
  }

  /// The offset and the number of the next line.
  std::size_t offset() const { return at_; }
  std::uint32_t number() const { return number_; }

 private:
  std::string_view text_;
  std::size_t at_;
  std::uint32_t number_;
};

}  // namespace symplant::read

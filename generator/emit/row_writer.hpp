// Writes rows as text. All tables in generated code are written with it.
#pragma once

#include <charconv>
#include <concepts>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "base/text_source.hpp"
#include "emit/encode.hpp"

namespace symplant::emit {

/// Writes rows, a line each. A user's text may be added by comment() and literal() only. The writer either keeps all
/// rows, for take(), or passes them to a sink, until finish().
class RowWriter {
 public:
  RowWriter() { buffer_.resize(256); }
  explicit RowWriter(base::TextSink& sink) : sink_(&sink) { buffer_.resize(kHandedOn); }

  RowWriter& text(std::string_view text) {
    filled_ += text.copy(room(text.size()), text.size());  // unlike memcpy, also of a text without an address
    return *this;
  }
  template <std::integral Number>
  RowWriter& number(Number value) {
    return digits(value, 10);
  }
  /// `0x1F`
  RowWriter& hex(std::uint64_t value) { return text("0x").digits(value, 16); }
  /// Numbers with commas between.
  template <std::integral First, std::integral... Rest>
  RowWriter& numbers(First first, Rest... rest) {
    number(first);
    (text(", ").number(rest), ...);
    return *this;
  }
  RowWriter& comment(std::string_view utf8) {
    const std::size_t plain = plain_in_comment(utf8);
    text(utf8.substr(0, plain));
    return plain == utf8.size() ? *this : encoded(append_comment, utf8.substr(plain));
  }
  RowWriter& literal(std::string_view bytes) {
    const std::size_t plain = plain_in_literal(bytes);
    text(bytes.substr(0, plain));
    return plain == bytes.size() ? *this : encoded(append_literal, bytes.substr(plain));
  }

  /// All rows, without the final line end.
  std::string take() {
    buffer_.resize(filled_ == 0 ? 0 : filled_ - 1);
    return std::move(buffer_);
  }
  std::string take_or(std::string_view none) { return filled_ == 0 ? std::string(none) : take(); }
  /// Passes the remaining rows to the sink, without the final line end.
  void finish() {
    if (filled_ > 1) sink_->put({buffer_.data(), filled_ - 1});
    filled_ = 0;
  }

 private:
  static constexpr std::size_t kHandedOn = std::size_t{1} << 18;  ///< bytes at a time
  static constexpr std::size_t kMostDigits = 24;

  char* room(std::size_t size) {
    if (buffer_.size() - filled_ < size) make_room(size);
    return buffer_.data() + filled_;
  }
  /// Keeps the last byte: it may be the final line end, and comment() depends on the byte before.
  void make_room(std::size_t size) {
    if (sink_ != nullptr && filled_ > 1) {
      sink_->put({buffer_.data(), filled_ - 1});
      buffer_[0] = buffer_[filled_ - 1];
      filled_ = 1;
    }
    if (buffer_.size() - filled_ < size) buffer_.resize(2 * buffer_.size() + size);
  }
  template <std::integral Number>
  RowWriter& digits(Number value, int base) {
    char* const begin = room(kMostDigits);
    filled_ += static_cast<std::size_t>(std::to_chars(begin, begin + kMostDigits, value, base).ptr - begin);
    return *this;
  }
  RowWriter& encoded(void (*append)(std::string&, std::string_view), std::string_view bytes) {
    std::string encoded(filled_ == 0 ? 0 : 1, filled_ == 0 ? '\0' : buffer_[filled_ - 1]);
    const std::size_t before = encoded.size();
    append(encoded, bytes);
    return text(std::string_view(encoded).substr(before));
  }

  base::TextSink* sink_ = nullptr;
  std::string buffer_;  ///< only its first `filled_` bytes are valid
  std::size_t filled_ = 0;
};

/// Writes rows on demand, the same ones each time.
using RowSource = std::function<void(RowWriter&)>;

}  // namespace symplant::emit

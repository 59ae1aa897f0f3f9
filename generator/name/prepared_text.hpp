// A text cut into words, as patterns see it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace symplant::name {

/// The characters that separate words: a blank, and those given.
class Separators {
 public:
  explicit Separators(std::string_view characters);

  /// The length in bytes of the separator at `offset`; 0 if there is none.
  std::size_t length_at(std::string_view text, std::size_t offset) const {
    const auto byte = static_cast<unsigned char>(text[offset]);
    if (byte < 0x80) return ascii_[byte] ? 1 : 0;
    return others_.empty() ? 0 : other_length_at(text, offset);
  }

 private:
  std::size_t other_length_at(std::string_view text, std::size_t offset) const;

  std::array<bool, 128> ascii_{};
  std::vector<std::string> others_;
};

struct Word {
  std::uint32_t begin = 0;  ///< offset in the text
  std::uint32_t end = 0;
};

/// A text in normal form, without separators at its ends, its folded form of the same length, and its words. An object
/// is used for many texts, so that it rarely allocates.
class PreparedText {
 public:
  /// `text` must be in normal form. O(text).
  void prepare(std::string_view text, const Separators& separators);

  std::string_view shown() const { return shown_; }
  std::string_view folded() const { return folded_; }
  std::size_t size() const { return shown_.size(); }
  const std::vector<Word>& words() const { return words_; }
  bool is_separator(std::size_t offset) const { return separator_[offset] != 0; }
  /// The end of the word or of the run of separators that `offset` is in.
  std::size_t run_end(std::size_t offset) const {
    const std::uint8_t kind = separator_[offset];
    while (offset < size() && separator_[offset] == kind) ++offset;
    return offset;
  }

 private:
  std::string shown_;
  std::string folded_;
  std::vector<std::uint8_t> separator_;  // for each byte
  std::vector<Word> words_;
};

/// The words of [begin, end) of a text, joined by `joint`.
std::string joined_words(const PreparedText& text, std::size_t begin, std::size_t end, char joint);

}  // namespace symplant::name

// Words that differ by a slip (a typing mistake), or are forms of one word.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace symplant::check {

/// Whether two tasks that differ look like forms of one word, such as `CLAMP` and `CLAMPED`, `CLOSE` and `CLOSING`:
/// without an `E` at the end, one is the beginning of the other and has three letters or more. Sequence numbers must be
/// equal.
bool bent_alike(std::string_view a, std::string_view b);

/// The characters of a text in capitals.
std::u32string capitals(std::string_view text);

/// Whether two texts in capitals differ by one slip: a letter is added, missing or replaced, or two adjacent letters
/// are exchanged. Different digits are not a slip: `CLAMP1` and `CLAMP2` are two things.
bool differ_by_slip(std::u32string_view a, std::u32string_view b);
/// Whether two texts of equal length differ in exactly one letter.
bool differ_by_another_letter(std::u32string_view a, std::u32string_view b);
/// Whether one text is the other with an ending (`CLOSE`, `CLOSED`): two words for one thing, not a slip.
bool differ_by_ending(std::u32string_view a, std::u32string_view b);
/// Whether texts that differ by a slip may be two codes. They may if the letter that is replaced, added or missing is
/// in a run of at most four letters (`PB1` and `PL1`, button and lamp), or if both letters name an axis or a side (X,
/// Y, Z; at the end of a run A to D, or L and R).
bool may_be_codes(std::u32string_view a, std::u32string_view b);

struct CountedWord {
  std::u32string text;  ///< in capitals
  std::uint64_t count = 0;
};

/// Finds the common words near a word. Each word is filed under itself and under itself without each of its letters
/// (the deletion neighborhood of Mor and Fraenkel, 1982). Each file keeps only its three most common words, so that a
/// word costs O(length) lookups, however many are near each other. Words of more than 128 letters are near nothing.
class NearWords {
 public:
  /// `words` must outlive this.
  explicit NearWords(const std::vector<CountedWord>& words);

  /// The words near a text, without the text itself, the most common first.
  std::vector<std::uint32_t> near(const std::u32string& text) const;

 private:
  const std::vector<CountedWord>& words_;
  std::vector<std::uint32_t> order_;                                     ///< the most common first
  std::unordered_map<std::size_t, std::array<std::uint32_t, 3>> files_;  ///< by hash: indexes in `order_`
};

}  // namespace symplant::check

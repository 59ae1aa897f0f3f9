// Words that differ by a slip of the hand, found without comparing each with each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace symplant::check {

/// Whether two words, in capitals, differ by one slip: a letter more, less or another, or two neighbors exchanged.
/// Digits and `#` are no slip: `CLAMP1` and `CLAMP2` are two things. Words of fewer than two letters never do.
/// O(length).
bool differ_by_slip(std::u32string_view a, std::u32string_view b);

/// How many of its characters are neither digits nor `#`.
std::size_t letters_in(std::u32string_view word);

/// Whether one word is the other with an ending (`CLOSE`, `CLOSED`): two words for one thing, and no slip.
bool differ_by_ending(std::u32string_view a, std::u32string_view b);

/// Whether two words that differ by a slip differ in one letter of a short code, where one letter often distinguishes
/// two classes: `PB#` and `PL#` (button and lamp), `PB#` and `PBL#`. The letter is another one, more or less, not
/// exchanged with its neighbor, in a run of at most four letters. O(length).
bool differ_by_class_letter(std::u32string_view a, std::u32string_view b);

/// Whether two words of one length differ in a letter that names an axis or a side: X, Y and Z anywhere, or, at the end
/// of a run of letters, A to D, or L and R. O(length).
bool differ_by_axis(std::u32string_view a, std::u32string_view b);

/// Whether two words of one length differ in one letter, another one. O(length).
bool differ_by_another_letter(std::u32string_view a, std::u32string_view b);

/// The words of a level with how often each is there, to ask for the common ones near a word. Each word is filed under
/// itself and under itself without each of its letters (the deletion neighbourhood of Mor and Fraenkel, 1982); of each
/// such file only the kBest commonest words are kept, so that any number of words that are all near each other cost no
/// more: O(length) hash operations a word, and a question compares with at most kBest * (length + 1) words. Words
/// longer than kLongest are near nothing.
class NearWords {
 public:
  static constexpr std::size_t kBest = 3;
  static constexpr std::size_t kLongest = 64;

  /// A word of the vocabulary, by its index.
  struct Word {
    std::u32string text;  ///< in capitals
    std::uint64_t count;
  };

  /// `words` must outlive this.
  explicit NearWords(const std::vector<Word>& words);

  /// The words near `words[location]` that are more common, or as common and before it, the most common first.
  std::vector<std::uint32_t> commoner_near(std::uint32_t location) const;

 private:
  static constexpr std::uint32_t kUndriven = 0xFFFF'FFFF;
  struct File {
    std::array<std::uint32_t, kBest> best{kUndriven, kUndriven, kUndriven};
  };

  bool commoner(std::uint32_t a, std::uint32_t b) const;
  void put(std::uint64_t key, std::uint32_t location);

  const std::vector<Word>& words_;
  std::unordered_map<std::uint64_t, File> files_;
};

}  // namespace symplant::check

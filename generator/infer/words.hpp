// The texts of samples as words, for looking at what they have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "infer/evaluate.hpp"
#include "name/naming.hpp"
#include "name/vocabulary.hpp"

namespace symplant::infer {

/// The words of one sample's text, folded.
struct SampleWords {
  std::uint32_t sample = 0;
  bool operation = false;
  std::vector<std::string> words;
};

/// The text of one source, as a rule of `naming` reads it; samples without text are left out.
std::vector<SampleWords> words_of(std::span<const Sample> samples, name::Source source, const name::Naming& naming,
                                  const name::Vocabulary& vocabulary);

/// The words that do not say the side.
std::vector<SampleWords> without_sides(std::vector<SampleWords> texts, const name::Vocabulary& vocabulary);

/// A word with `#` for each run of digits.
std::string shape_of(std::string_view word);
/// A regular expression for all words of a shape.
std::string expression_of_shape(std::string_view shape);
/// `text` with a backslash before each character that patterns of names read as syntax.
std::string quoted(std::string_view text);
bool is_number(std::string_view word);
/// Words with a blank between two of them.
std::string joined_words(const std::vector<std::string>& words);
/// Whether one of the words is `known`, digits at its end apart; words of scripts without blanks may be part of a word,
/// and phrases several words. Follows the same rules as name::RequiredWords.
bool contains(const std::vector<std::string>& words, std::string_view known, const name::Vocabulary& vocabulary);

}  // namespace symplant::infer

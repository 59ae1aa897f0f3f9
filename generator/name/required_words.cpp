// Looks for words that a text must have.
#include "name/required_words.hpp"

#include <algorithm>

#include "text/folding.hpp"
#include "text/utf8.hpp"

namespace symplant::name {
namespace {

std::string_view without_digits(std::string_view word) {
  return word.substr(0, word.find_last_not_of("0123456789") + 1);
}

/// The words of a text, without digits at their ends, separated and enclosed by blanks.
std::string spaced(const PreparedText& text) {
  std::string words = " ";
  for (const Word& word : text.words()) {
    words.append(without_digits(text.folded().substr(word.begin, word.end - word.begin))).append(" ");
  }
  return words;
}

}  // namespace

RequiredWords::RequiredWords(const std::vector<std::string>& words, const Separators& separators) {
  PreparedText text;
  for (const std::string& word : words) {
    text.prepare(text::normal_form(word), separators);
    if (text.size() == 0) continue;
    if (text.words().size() > 1) {
      phrases_.push_back(spaced(text));
    } else if (text::code_point_at(text.folded(), 0).value >= kFirstWithoutBlanks) {
      inside_.emplace_back(text.folded());
    } else {
      words_.emplace(without_digits(text.folded()));
    }
  }
}

bool RequiredWords::are_in(const PreparedText& text, const Vocabulary& vocabulary) const {
  for (const Word& word : text.words()) {
    const std::string_view folded = text.folded().substr(word.begin, word.end - word.begin);
    if (words_.contains(std::string(without_digits(folded)))) return true;
    if (inside_.empty() || vocabulary.motion(folded)) continue;
    for (const std::string& part : inside_) {
      if (folded.find(part) != std::string_view::npos) return true;
    }
  }
  const auto within = [](std::string_view whole) {
    return [whole](const std::string& part) { return whole.find(part) != std::string_view::npos; };
  };
  return !phrases_.empty() && std::any_of(phrases_.begin(), phrases_.end(), within(spaced(text)));
}

}  // namespace symplant::name

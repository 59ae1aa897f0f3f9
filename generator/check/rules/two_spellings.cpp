// SP211 two-spellings: one word is spelled in two forms.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "check/rules.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kTwoSpellingsPage =
    R"(The names or comments of a list have one word in two spellings, such as `SAFTY` and `SAFETY`, or `NORMAL` and `NOMAL`: a letter
within the word is missing, or two are exchanged. The message counts both. It does not say which one is right.

**What the model loses.** A pattern of a naming rule or of plant.json that has one spelling does not match the other.

**How to fix it.** Write one spelling everywhere. In naming.json, `"replace": [["SAFTY", "SAFETY"]]` makes them equal.
)";

constexpr std::size_t kLeastLetters = 5;  ///< of the shorter word; shorter words are often two words
constexpr std::size_t kMostLetters = 32;
constexpr std::size_t kLeastCount = 2;  ///< of the more frequent word

/// A word of Latin letters, and the first symbol that has it.
struct Word {
  std::size_t count = 0;
  const model::Symbol* first = nullptr;
  std::string_view as_written;
};
using Words = std::map<std::string, Word>;

bool is_latin(char c) { return text::upper(c) >= 'A' && text::upper(c) <= 'Z'; }

void add_words(const model::Symbol& symbol, std::string_view text, Words& words) {
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = begin;
    while (end < text.size() && is_latin(text[end])) ++end;
    // Next to a character of another script it is a part of a word.
    const bool part = (begin > 0 && static_cast<unsigned char>(text[begin - 1]) >= 0x80) ||
                      (end < text.size() && static_cast<unsigned char>(text[end]) >= 0x80);
    if (!part && end - begin >= kLeastLetters && end - begin <= kMostLetters) {
      Word& word = words[text::to_upper(text.substr(begin, end - begin))];
      if (word.count++ == 0) word = {1, &symbol, text.substr(begin, end - begin)};
    }
    begin = std::max(end, begin + 1);
  }
}

/// A pair of spellings; the rarer one first.
using Pair = std::pair<Words::const_iterator, Words::const_iterator>;

Pair rarer_first(Words::const_iterator a, Words::const_iterator b) {
  return a->second.count <= b->second.count ? Pair(a, b) : Pair(b, a);
}

/// Pairs of which one lacks an inner letter of the other, or has two inner letters exchanged. A first or last letter
/// more is another form or another word. O(letters).
std::vector<Pair> pairs_in(const Words& words) {
  std::vector<Pair> pairs;
  const auto add = [&](Words::const_iterator word, const std::string& other) {
    const auto found = words.find(other);
    if (found != words.end() && found != word) pairs.push_back(rarer_first(word, found));
  };
  for (auto word = words.begin(); word != words.end(); ++word) {
    const std::string& letters = word->first;
    for (std::size_t i = 1; i + 1 < letters.size(); ++i) {
      if (letters[i] == letters[i - 1] && i > 1) continue;  // the same word as without the letter before
      add(word, letters.substr(0, i) + letters.substr(i + 1));
    }
    for (std::size_t i = 1; i + 2 < letters.size(); ++i) {
      std::string exchanged = letters;
      std::swap(exchanged[i], exchanged[i + 1]);
      if (exchanged > letters) add(word, exchanged);
    }
  }
  return pairs;
}

void check_two_spellings(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  Words words;
  for (const model::Symbol& symbol : plant.symbols) {
    if (!symbol.row->is_named_by_address()) add_words(symbol, symbol.name(), words);
    add_words(symbol, symbol.row->comment, words);
  }
  for (const auto& [rare, common] : pairs_in(words)) {
    if (common->second.count < kLeastCount) continue;
    diagnostics.add(
        rule.info, diag::Subjects{{symbol_named(rare->first), symbol_named(rare->second.first->name())}, {}, {}},
        fmt::format("`{}` ({} time{}) and `{}` ({} times) look like one word; write it alike everywhere", rare->first,
                    rare->second.count, rare->second.count == 1 ? "" : "s", common->first, common->second.count),
        location_of(plant, *rare->second.first->row, rare->second.as_written),
        {{location_of(plant, *common->second.first->row, common->second.as_written), "the other spelling"}});
  }
}

}  // namespace

const Rule kTwoSpellings{
    {"SP211", "two-spellings", diag::Severity::warning, "one word is spelled in two forms", kTwoSpellingsPage},
    check_two_spellings};

}  // namespace symplant::check

// Guesses by the number of levels.
#include "findings/name_guess.hpp"

#include <algorithm>

#include "text/ascii.hpp"

namespace symplant::findings {
namespace {

constexpr std::size_t kWords = 5;
constexpr std::size_t kDirection = 3;
constexpr std::string_view kUnknown = "*";

using Words = std::vector<std::string>;

bool is_word(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

class Guesses {
 public:
  explicit Guesses(const name::NamingRule& rule) : rule_(rule) {}

  /// Of five words. The direction must be one, and no more than one word unknown.
  void add(const Words& words) {
    if (words.size() != kWords) return;
    NameGuess guess;
    std::size_t unknown = 0;
    for (std::size_t i = 0; i < kWords; ++i) {
      const bool known = !words[i].empty() && std::all_of(words[i].begin(), words[i].end(), is_word) &&
                         (i != kDirection || is_direction(words[i]));
      unknown += known ? 0U : 1U;
      guess.levels[i] = known ? words[i] : kUnknown;
    }
    if (unknown <= 1) guesses_.push_back(std::move(guess));
  }

  /// One word is missing: anywhere.
  void add_word(const Words& words) {
    for (std::size_t at = 0; at <= words.size(); ++at) {
      Words more = words;
      more.insert(more.begin() + static_cast<std::ptrdiff_t>(at), std::string(kUnknown));
      add(more);
    }
  }

  /// One word is too many, or one was split in two.
  void drop_word(const Words& words) {
    for (std::size_t at = 0; at < words.size(); ++at) {
      Words fewer = words;
      const auto here = fewer.begin() + static_cast<std::ptrdiff_t>(at);
      if (at + 1 < words.size()) {
        Words joined = fewer;
        joined[at] += joined[at + 1];
        joined.erase(joined.begin() + static_cast<std::ptrdiff_t>(at) + 1);
        add(joined);
      }
      fewer.erase(here);
      add(fewer);
    }
  }

  std::vector<NameGuess> take() { return std::move(guesses_); }

 private:
  bool is_direction(std::string_view word) const {
    return std::any_of(rule_.directions.begin(), rule_.directions.end(),
                       [&](const auto& known) { return text::equal_ignoring_case(known.word, word); });
  }

  const name::NamingRule& rule_;
  std::vector<NameGuess> guesses_;
};

/// Parts a name; what is no separator, letter or digit stays in its word.
Words parted(std::string_view name, char separator) {
  Words words(1);
  for (const char c : name) {
    if (c == separator) {
      words.emplace_back();
    } else {
      words.back() += text::upper(c);
    }
  }
  return words;
}

std::string with_separators(std::string_view name, char separator) {
  std::string result;
  for (const char c : name) result += is_word(text::upper(c)) ? c : separator;
  return result;
}

std::string without_foreign(std::string_view name, char separator) {
  std::string result;
  for (const char c : name) {
    if (c == separator || is_word(text::upper(c))) result += c;
  }
  return result;
}

}  // namespace

std::string NameGuess::path() const {
  for (std::size_t i = 0; i < kDirection; ++i) {
    if (levels[i] == kUnknown) return {};
  }
  return levels[0] + "_" + levels[1] + "_" + levels[2];
}

std::string NameGuess::name() const {
  std::string name = levels[0];
  for (std::size_t i = 1; i < kWords; ++i) name += "_" + levels[i];
  return name;
}

std::vector<NameGuess> guess_names(std::string_view name, const name::NamingRule& rule) {
  using name::Level;
  const std::vector<Level> known{Level::line, Level::process, Level::device, Level::direction, Level::task};
  if (rule.levels != known || rule.separator != U'_') return {};
  constexpr char separator = '_';
  Guesses guesses(rule);
  const Words words = parted(name, separator);
  if (words.size() == kWords) guesses.add(words);
  if (words.size() + 1 == kWords) guesses.add_word(words);
  if (words.size() == kWords + 1) guesses.drop_word(words);
  if (const std::string cleaned = without_foreign(name, separator); cleaned != name) {
    guesses.add(parted(cleaned, separator));
    guesses.add(parted(with_separators(name, separator), separator));
  }
  return guesses.take();
}

}  // namespace symplant::findings

// SP210 letters-alike: words in letters of two scripts that look alike.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "check/rules.hpp"
#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kLettersAlikePage =
    R"(A word in a name is written with Cyrillic or Greek letters that look like Latin ones, and other names have the same word in Latin
letters: `КА12` (Cyrillic) and `KA2`. They look equal and are different names.

**What the model loses.** Symbols of one device fall apart into two devices, and a pattern such as `KA[0-9]+` reads only some of
them.

**How to fix it.** Write the word in Latin letters in the engineering tool. In a naming rule, `"replace": [["КА", "KA"]]` makes
them equal.
)";

struct Alike {
  char32_t letter;
  char latin;
};

/// Capital letters of Cyrillic and Greek with a Latin look-alike.
constexpr auto kAlike =
    std::to_array<Alike>({{U'А', 'A'}, {U'В', 'B'}, {U'Е', 'E'}, {U'К', 'K'}, {U'М', 'M'}, {U'Н', 'H'}, {U'О', 'O'},
                          {U'Р', 'P'}, {U'С', 'C'}, {U'Т', 'T'}, {U'У', 'Y'}, {U'Х', 'X'}, {U'Α', 'A'}, {U'Β', 'B'},
                          {U'Ε', 'E'}, {U'Ζ', 'Z'}, {U'Η', 'H'}, {U'Ι', 'I'}, {U'Κ', 'K'}, {U'Μ', 'M'}, {U'Ν', 'N'},
                          {U'Ο', 'O'}, {U'Ρ', 'P'}, {U'Τ', 'T'}, {U'Υ', 'Y'}, {U'Χ', 'X'}});

/// The Latin letter that a character is or looks like; else 0.
char latin_of(char32_t character) {
  if (character < 0x80) {
    const char letter = text::upper(static_cast<char>(character));
    return letter >= 'A' && letter <= 'Z' ? letter : '\0';
  }
  const auto found =
      std::find_if(kAlike.begin(), kAlike.end(), [&](const Alike& one) { return one.letter == character; });
  return found == kAlike.end() ? '\0' : found->latin;
}

/// Symbols whose names have a word, in Latin letters only and with other ones.
struct Spellings {
  const model::Symbol* latin = nullptr;
  std::vector<const model::Symbol*> others = {};
};
using ByWord = std::map<std::string, Spellings>;

/// Adds the words of a name: runs of letters. Words with letters that look like no Latin one are left out.
void add_words(const model::Symbol& symbol, ByWord& words) {
  const std::string_view name = symbol.name();
  std::string word;
  bool mixed = false;
  bool foreign = false;
  const auto end_word = [&] {
    if (!word.empty() && !foreign) {
      Spellings& spellings = words[word];
      if (mixed) spellings.others.push_back(&symbol);
      if (!mixed && spellings.latin == nullptr) spellings.latin = &symbol;
    }
    word.clear();
    mixed = foreign = false;
  };
  for (std::size_t at = 0; at < name.size();) {
    const text::CodePoint character = text::code_point_at(name, at);
    at += character.length;
    const char latin = latin_of(character.value);
    if (latin != '\0') {
      word += latin;
      mixed = mixed || character.value >= 0x80;
    } else if (character.value >= 0x80) {
      word += '?';
      foreign = true;
    } else {
      end_word();
    }
  }
  end_word();
}

/// The name with Latin letters for those that look like them.
std::string latin_name(std::string_view name) {
  std::string latin;
  for (std::size_t at = 0; at < name.size();) {
    const text::CodePoint character = text::code_point_at(name, at);
    const char letter = character.value < 0x80 ? '\0' : latin_of(character.value);
    if (letter != '\0') {
      latin += letter;
    } else {
      latin += name.substr(at, character.length);
    }
    at += character.length;
  }
  return latin;
}

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

void check_letters_alike(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  const auto has_others = [](const model::Symbol& symbol) { return !is_ascii(symbol.name()); };
  if (std::none_of(plant.symbols.begin(), plant.symbols.end(), has_others)) return;
  ByWord words;
  for (const model::Symbol& symbol : plant.symbols) add_words(symbol, words);
  for (const auto& [word, spellings] : words) {
    if (spellings.latin == nullptr || spellings.others.empty()) continue;
    const model::Symbol& other = *spellings.others.front();
    const std::size_t more = spellings.others.size() - 1;
    diag::Diagnostic& finding = diagnostics.add(
        rule.info, about(other),
        fmt::format("`{}`{} Cyrillic or Greek letters that look like the Latin `{}` of `{}`; write the word "
                    "in the same letters everywhere",
                    other.name(), more == 0 ? " has" : fmt::format(" and {} more have", more), word,
                    spellings.latin->name()),
        location_of(plant, other), {{location_of(plant, *spellings.latin), "in Latin letters"}});
    for (const model::Symbol* symbol : spellings.others) {
      finding.renames.push_back(rename_of(*symbol, latin_name(symbol->name()), true));
    }
  }
}

}  // namespace

const Rule kLettersAlike{{"SP210", "letters-alike", diag::Severity::warning,
                          "words in letters of two scripts that look alike", kLettersAlikePage, diag::Rank::name},
                         check_letters_alike};

}  // namespace symplant::check

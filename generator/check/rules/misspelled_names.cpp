// Rules: names that look misspelled.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "check/rules.hpp"
#include "check/spelling/slips.hpp"
#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

std::string reason(const Slip& slip) {
  const bool one = slip.symbols.size() == 1;
  if (slip.why == Slip::Why::lacks) {
    return fmt::format("and `{}` lacks just {}", slip.meant_path, one ? "this symbol" : "these symbols");
  }
  const auto have = [&](std::string_view level) {
    return fmt::format("which {} devices have for their {}{}", slip.others, level,
                       level == "process" ? ", digits apart" : "");
  };
  switch (slip.level) {
    case name::Level::line:
      return have("line");
    case name::Level::process:
      return have("process");
    case name::Level::task:
      return fmt::format("which {} symbols have for their task", slip.others);
    default:
      return slip.others == 1 ? "which another device is called, digits apart"
                              : fmt::format("which {} devices are called, digits apart", slip.others);
  }
}

/// The text with the word that is meant. `at` is the index of the word that is written.
std::string corrected(std::string_view text, std::size_t at, const Slip& slip) {
  if (at + slip.written.size() > text.size()) return std::string(text);  // a device's path, the slip is in the task
  return std::string(text).replace(at, slip.written.size(), slip.meant);
}

/// The symbols as written, and the device that is meant. Explains the devices that are written, and what is missing in
/// those that are meant.
diag::Subjects about_slip(const model::PlantModel& plant, const Slip& slip) {
  const model::Symbol& first = plant.symbols[slip.symbols.front()];
  const auto at = static_cast<std::size_t>(slip.written.data() - first.name().data());
  diag::Subjects subjects = about(first);
  subjects.about.push_back(device(slip.meant_path));
  for (const std::uint32_t s : slip.symbols) {
    const model::Symbol& symbol = plant.symbols[s];
    if (s != slip.symbols.front()) {
      for (diag::Subject& subject : about(symbol).about) subjects.about.push_back(std::move(subject));
    }
    subjects.explains.push_back(device(symbol.reading.device_path()));
    const std::string meant_path = corrected(symbol.reading.device_path(), at, slip);
    explain_missing(subjects, corrected(symbol.name(), at, slip), meant_path, symbol.direction);
  }
  return subjects;
}

std::string slip_message(const model::PlantModel& plant, const Slip& slip) {
  if (slip.why != Slip::Why::complements) {
    return fmt::format("`{}` looks like a typo of `{}`, {}; write `{}` if that is meant", slip.written, slip.meant,
                       reason(slip), slip.meant);
  }
  const model::Symbol& first = plant.symbols[slip.symbols.front()];
  const std::string_view path = first.reading.device_path();
  return slip.symbols.size() == 1
             ? fmt::format(
                   "`{}` is the only symbol of `{}`, and just the one that `{}` lacks: if they are one device, "
                   "write `{}` or `{}` in all names",
                   first.name(), path, slip.meant_path, slip.meant, slip.written)
             : fmt::format(
                   "`{}` has just the {}s that `{}` lacks: if they are one device, write `{}` or `{}` in all "
                   "names",
                   path, direction_text(first.direction), slip.meant_path, slip.meant, slip.written);
}

void check_name_slip(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const Slip& slip : find_slips(plant, subject.classes)) {
    const model::Symbol& first = plant.symbols[slip.symbols.front()];
    std::vector<diag::Related> related;
    if (slip.meant_device != model::kNone && slip.level != name::Level::task) {
      const model::Symbol& known = plant.symbols[subject.classes.first_symbol(slip.meant_device)];
      const bool unknown = slip.why == Slip::Why::complements;
      related.push_back({location_of(plant, known), unknown ? "the other device" : "the device that is meant"});
    }
    for (std::size_t i = 1; i < slip.symbols.size(); ++i) {
      const model::Symbol& other = plant.symbols[slip.symbols[i]];
      related.push_back({location_of(plant, other), "here too"});
    }
    diag::Location location = location_of(plant, first);
    if (location.span.end - location.span.begin == first.name().size()) {
      const auto begin = static_cast<std::size_t>(slip.written.data() - first.name().data());
      location.span = {location.span.begin + begin, location.span.begin + begin + slip.written.size()};
    }
    diag::Diagnostic& finding = diagnostics.add(rule.info, about_slip(plant, slip), slip_message(plant, slip),
                                                std::move(location), std::move(related));
    const auto at = static_cast<std::size_t>(slip.written.data() - first.name().data());
    for (const std::uint32_t s : slip.symbols) {
      const model::Symbol& symbol = plant.symbols[s];
      finding.renames.push_back(rename_of(symbol, corrected(symbol.name(), at, slip), slip.why == Slip::Why::lacks));
    }
  }
}

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

const Rule kNameSlip{
    {"SP205", "name-slip", diag::Severity::warning, "a word in a name looks like a typo of the one that is meant",
     R"(A line, process, device or task is written with a letter more, less or other, or with two neighbors exchanged, than the word
that is meant: `CLAPM1` for `CLAMP1`. Digits are never a slip: `CLAMP1` and `CLAMP2` are two devices. Neither is another letter
in a code of up to four letters (`PB1`, `PL1`), an axis or a side (`PBLX`, `PBLY`), or a word that has no symbol of this
direction. A single symbol whose code is rare is one, though.

The list itself must give evidence. One of these holds:

- The device that is meant lacks exactly this symbol (its siblings, the devices whose names differ in digits only, have it, or its
  other side is there), and the device as written is not expected to have it.
- The word is rare. The one that is meant is at least eight times as common (a task: four times) and has nothing there yet.
- Two devices differ only in their line or process and complement each other: one has just the operations or events that the
  other lacks, such as `EXCELL_MB_AGV_I_P1` and `EXLINE_MB_AGV_O_P1`, `EXLINE_MB_AGV_O_P2`, `EXLINE_MB_AGV_I_P2`.

**What the model loses.** The symbol becomes a separate device, or a separate state. The device that is meant lacks an
operation, so that the PLC's command has no effect, or it lacks an event, so that the PLC waits in vain. Patterns of plant.json
do not match the symbol.

**How to fix it.** Write the word that is meant. If both words are meant, ignore the finding by `check.ignore` in plant.json.
)",
     diag::Rank::name},
    check_name_slip};

const Rule kLettersAlike{
    {"SP210", "letters-alike", diag::Severity::warning, "words in letters of two scripts that look alike",
     R"(A word in a name is written with Cyrillic or Greek letters that look like Latin ones, and other names have the same word in Latin
letters: `КА12` (Cyrillic) and `KA2`. They look equal and are different names.

**What the model loses.** Symbols of one device fall apart into two devices, and a pattern such as `KA[0-9]+` reads only some of
them.

**How to fix it.** Write the word in Latin letters in the engineering tool. In a naming rule, `"replace": [["КА", "KA"]]` makes
them equal.
)",
     diag::Rank::name},
    check_letters_alike};

}  // namespace symplant::check

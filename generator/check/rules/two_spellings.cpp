// SP211 two-spellings: one word is spelled in two forms.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "check/rules.hpp"
#include "text/ascii.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kTwoSpellingsPage =
    R"(The names or comments of a list have one word in two spellings, such as `SAFTY` and `SAFETY`, or `NORMAL` and `NOMAL`: a letter
within the word is missing, or two are exchanged. The message counts both in all rows. It does not say which one is right.

**What the model loses.** A pattern of a naming rule or of plant.json that has one spelling does not match the other.

**How to fix it.** Write one spelling everywhere. In naming.json, `"replace": [["SAFTY", "SAFETY"]]` makes them equal.
)";

constexpr std::size_t kLeastLetters = 5;  ///< of the shorter word; shorter words are often two words
constexpr std::size_t kMostLetters = 32;
constexpr std::size_t kLeastCount = 2;  ///< of the more frequent word

/// A word of Latin letters.
struct Word {
  std::size_t count = 0;  ///< in all rows, internal ones too
  const read::ListRow* row = nullptr;
  std::string_view as_written;
  const model::Symbol* used_by = nullptr;  ///< the first input or output
};
using Words = text::ByName<Word>;

bool is_latin(char c) { return text::upper(c) >= 'A' && text::upper(c) <= 'Z'; }

/// Calls `visit` with each run of Latin letters, and with what is between them.
template <class Visit>
void visit_runs(std::string_view text, Visit visit) {
  for (std::size_t begin = 0; begin < text.size();) {
    const bool latin = is_latin(text[begin]);
    std::size_t end = begin + 1;
    while (end < text.size() && is_latin(text[end]) == latin) ++end;
    visit(text.substr(begin, end - begin), latin);
    begin = end;
  }
}

/// Adds the words of a text. Next to a character of another script, Latin letters are a part of a word.
void add_words(std::string_view text, const read::ListRow& row, const model::Symbol* symbol, Words& words) {
  const auto is_foreign = [&](std::size_t at) {
    return at < text.size() && static_cast<unsigned char>(text[at]) >= 0x80;
  };
  visit_runs(text, [&](std::string_view run, bool latin) {
    if (!latin || run.size() < kLeastLetters || run.size() > kMostLetters) return;
    const auto begin = static_cast<std::size_t>(run.data() - text.data());
    if (is_foreign(begin - 1) || is_foreign(begin + run.size())) return;
    Word& word = words[run];
    if (word.count++ == 0) word = {1, &row, run, nullptr};
    if (word.used_by == nullptr && symbol != nullptr) word = {word.count, &row, run, symbol};
  });
}

Words words_of(const model::PlantModel& plant) {
  Words words;
  auto next = plant.symbols.begin();  // in the order of lists and rows
  for (const model::PlantList& list : plant.lists) {
    for (const read::ListRow& row : list.table->rows) {
      const bool is_io = next != plant.symbols.end() && next->row == &row;
      const model::Symbol* symbol = is_io ? &*next++ : nullptr;
      if (!row.is_named_by_address()) add_words(row.name, row, symbol, words);
      add_words(row.comment, row, symbol, words);
    }
  }
  return words;
}

/// Finds pairs of which an input or output uses the rarer one. O(rows + words * letters).
class TwoSpellings {
 public:
  TwoSpellings(const Rule& rule, const model::PlantModel& plant)
      : rule_(rule), plant_(plant), words_(words_of(plant)) {}

  std::vector<diag::Diagnostic> find() {
    std::vector<std::string> sorted;
    for (const auto& [word, of] : words_) sorted.push_back(text::to_upper(word));
    std::sort(sorted.begin(), sorted.end());
    for (const std::string& word : sorted) look_at(word);
    add_renames();
    return std::move(found_);
  }

 private:
  /// Compares a word with those that lack an inner letter of it, or have two inner letters exchanged. A first or last
  /// letter more is another form or another word.
  void look_at(const std::string& word) {
    for (std::size_t i = 1; i + 1 < word.size(); ++i) {
      if (i > 1 && word[i] == word[i - 1]) continue;  // the same word as without the letter before
      compare(word, word.substr(0, i) + word.substr(i + 1));
    }
    for (std::size_t i = 1; i + 2 < word.size(); ++i) {
      std::string exchanged = word;
      std::swap(exchanged[i], exchanged[i + 1]);
      if (exchanged > word) compare(word, exchanged);
    }
  }

  void compare(const std::string& word, const std::string& other) {
    const auto found = words_.find(other);
    if (found == words_.end()) return;
    const bool first_is_rare = words_.find(word)->second.count <= found->second.count;
    const std::string& rare = first_is_rare ? word : other;
    const std::string& common = first_is_rare ? other : word;
    const Word& of_rare = words_.find(rare)->second;
    const Word& of_common = words_.find(common)->second;
    if (of_rare.used_by == nullptr || of_common.count < kLeastCount) return;
    diag::Diagnostic finding;
    finding.rule = &rule_.info;
    finding.severity = rule_.info.severity;
    finding.message = fmt::format("`{}` ({} time{}) and `{}` ({} times) look like one word; write it alike everywhere",
                                  rare, of_rare.count, of_rare.count == 1 ? "" : "s", common, of_common.count);
    finding.location = location_of(plant_, *of_rare.row, of_rare.as_written);
    finding.related = {{location_of(plant_, *of_common.row, of_common.as_written), "the other spelling"}};
    finding.subjects.about = {symbol_named(rare), symbol_named(of_rare.used_by->name())};
    // SP205 says which one is meant.
    if (plant_.pairing == nullptr) finding.subjects.follows = {device(of_rare.used_by->reading.device_path)};
    spellings_.try_emplace(rare, std::pair(common, found_.size()));
    found_.push_back(std::move(finding));
  }

  /// For the names of inputs and outputs with the rarer spelling.
  void add_renames() {
    if (spellings_.empty()) return;
    for (const model::Symbol& symbol : plant_.symbols) {
      std::string renamed;
      std::optional<std::size_t> by;
      visit_runs(symbol.name(), [&](std::string_view run, bool latin) {
        const auto found = latin ? spellings_.find(text::to_upper(run)) : spellings_.end();
        if (found != spellings_.end()) by = found->second.second;
        renamed += found == spellings_.end() ? run : std::string_view(found->second.first);
      });
      if (by) found_[*by].renames.push_back(rename_of(symbol, std::move(renamed), false));
    }
  }

  const Rule& rule_;
  const model::PlantModel& plant_;
  const Words words_;
  std::map<std::string, std::pair<std::string, std::size_t>> spellings_;  ///< rare: common, index in found_
  std::vector<diag::Diagnostic> found_;
};

void check_two_spellings(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  for (diag::Diagnostic& finding : TwoSpellings(rule, subject.plant).find()) diagnostics.add(std::move(finding));
}

}  // namespace

const Rule kTwoSpellings{
    {"SP211", "two-spellings", diag::Severity::warning, "one word is spelled in two forms", kTwoSpellingsPage},
    check_two_spellings};

}  // namespace symplant::check

// Rules: words of names and comments.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "check/rules.hpp"
#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

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
    if (plant_.pairing == nullptr) finding.subjects.follows = {device(of_rare.used_by->reading.device_path())};
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

constexpr std::size_t kShortestLimit = 16;
constexpr std::size_t kLeastCut = 3;

using WordSet = std::unordered_set<std::string_view, text::HashIgnoringCase, text::EqualIgnoringCase>;

/// The comments of one list.
struct Comments {
  std::vector<const model::Symbol*> longest;
  std::size_t length = 0;
  WordSet last;                    ///< last words of the longest comments that no other comment has
  WordSet others;                  ///< words of the other comments, until `last` is empty
  std::vector<std::string> words;  ///< the same in capitals, sorted
};

/// Letters, and the bytes of other scripts.
bool is_in_word(char c) {
  return (text::upper(c) >= 'A' && text::upper(c) <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

std::size_t begin_of_last_word(std::string_view text) {
  std::size_t begin = text.size();
  while (begin > 0 && is_in_word(text[begin - 1])) --begin;
  return begin;
}

void add_words(std::string_view text, Comments& comments) {
  while (!text.empty()) {
    const std::size_t begin = begin_of_last_word(text);
    if (begin < text.size() && comments.others.insert(text.substr(begin)).second)
      comments.last.erase(text.substr(begin));
    text.remove_suffix(text.size() - begin + (begin == 0 ? 0 : 1));
    if (begin == 0) break;
  }
}

/// Whether the last word is the beginning of another one, and is itself no word. Words of other scripts often differ in
/// an ending.
bool is_cut(const Comments& comments, std::string_view text) {
  const std::string last = text::to_upper(text.substr(begin_of_last_word(text)));
  if (comments.last.count(last) == 0) return false;
  if (std::any_of(last.begin(), last.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; })) return false;
  const auto next = std::lower_bound(comments.words.begin(), comments.words.end(), last);
  return next != comments.words.end() && std::string_view(*next).starts_with(last);
}

std::vector<Comments> comments_of(const model::PlantModel& plant) {
  std::vector<Comments> lists(plant.lists.size());
  for (const model::Symbol& symbol : plant.symbols) {
    Comments& comments = lists[symbol.list];
    if (symbol.row->comment.size() < std::max(comments.length, kShortestLimit)) continue;
    const std::size_t length = text::count_code_points(symbol.row->comment);
    if (length > comments.length) {
      comments.length = length;
      comments.longest.clear();
    }
    if (length == comments.length) comments.longest.push_back(&symbol);
  }
  for (Comments& comments : lists) {
    if (comments.longest.size() < kLeastCut) continue;
    for (const model::Symbol* symbol : comments.longest) {
      const std::string_view text = symbol->row->comment;
      if (const std::size_t begin = begin_of_last_word(text); begin < text.size())
        comments.last.insert(text.substr(begin));
    }
  }
  for (const model::Symbol& symbol : plant.symbols) {
    Comments& comments = lists[symbol.list];
    if (comments.last.empty()) continue;
    std::string_view text = symbol.row->comment;
    if (text.size() >= comments.length && text::count_code_points(text) == comments.length)
      text = text.substr(0, begin_of_last_word(text));
    add_words(text, comments);
  }
  for (Comments& comments : lists) {
    if (comments.last.empty()) continue;
    for (const std::string_view word : comments.others) comments.words.push_back(text::to_upper(word));
    std::sort(comments.words.begin(), comments.words.end());
  }
  return lists;
}

void check_text_cut(const Rule& rule, const Subject& subject, diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = subject.plant;
  for (const Comments& comments : comments_of(plant)) {
    if (comments.length < kShortestLimit) continue;
    std::vector<const model::Symbol*> cut;
    std::copy_if(comments.longest.begin(), comments.longest.end(), std::back_inserter(cut),
                 [&](const model::Symbol* symbol) { return is_cut(comments, symbol->row->comment); });
    if (cut.size() < kLeastCut) continue;
    const model::Symbol& first = *cut.front();
    diagnostics.add(
        rule.info, diag::Subjects{{symbol_named(first.name())}, {}, {}},
        fmt::format("{} comments of {} characters end within a word, such as `{}`, and none is longer: they "
                    "are cut; shorten them in the engineering tool",
                    cut.size(), comments.length, first.row->comment),
        location_of(plant, *first.row, first.row->comment));
  }
}

}  // namespace

const Rule kTwoSpellings{
    {"SP211", "two-spellings", diag::Severity::warning, "one word is spelled in two forms",
     R"(The names or comments of a list have one word in two spellings, such as `SAFTY` and `SAFETY`, or `NORMAL` and `NOMAL`: a letter
within the word is missing, or two are exchanged. The message counts both in all rows. It does not say which one is right.

**What the model loses.** A pattern of a naming rule or of plant.json that has one spelling does not match the other.

**How to fix it.** Write one spelling everywhere. In naming.json, `"replace": [["SAFTY", "SAFETY"]]` makes them equal.
)"},
    check_two_spellings};

const Rule kTextCut{
    {"SP212", "text-cut", diag::Severity::warning, "comments end at the length limit of a field",
     R"(Several of the longest comments of a list have exactly one length and end within a word: with the beginning of a word that other
comments have. The engineering tool, or an export, cut them there. GX Works keeps 32 characters of a device comment.

**What the model loses.** A naming rule that reads comments lacks the end of these texts, which often says what a signal means:
`forward end` and `forward start` may be cut to one text.

**How to fix it.** Shorten the comments in the engineering tool so that the important word is within the limit, or export them
with a longer field.
)"},
    check_text_cut};

}  // namespace symplant::check

// SP212 text-cut: comments end at the length limit of a field.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "check/rules.hpp"
#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

constexpr std::string_view kTextCutPage =
    R"(Several of the longest comments of a list have exactly one length and end within a word: with the beginning of a word that other
comments have. The engineering tool, or an export, cut them there. GX Works keeps 32 characters of a device comment.

**What the model loses.** A naming rule that reads comments lacks the end of these texts, which often says what a signal means:
`forward end` and `forward start` may be cut to one text.

**How to fix it.** Shorten the comments in the engineering tool so that the important word is within the limit, or export them
with a longer field.
)";

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

const Rule kTextCut{
    {"SP212", "text-cut", diag::Severity::warning, "comments end at the length limit of a field", kTextCutPage},
    check_text_cut};

}  // namespace symplant::check

// Rules: words of names and comments, and texts in a row.
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "check/rule.hpp"
#include "check/words.hpp"
#include "text/ascii.hpp"
#include "text/utf8.hpp"

namespace symplant::check {
namespace {

bool is_latin(char c) { return text::upper(c) >= 'A' && text::upper(c) <= 'Z'; }
bool is_foreign(char c) { return static_cast<unsigned char>(c) >= 0x80; }
bool has_foreign(std::string_view text) { return std::ranges::any_of(text, is_foreign); }

/// Calls `visit` with each word, a run of letters of any script, and its beginning.
template <class Visit>
void visit_words(std::string_view text, Visit visit) {
  const auto is_letter = [](char c) { return is_latin(c) || is_foreign(c); };
  for (auto begin = std::ranges::find_if(text, is_letter); begin != text.end();) {
    const auto end = std::find_if_not(begin, text.end(), is_letter);
    visit(std::string_view(begin, end), static_cast<std::size_t>(begin - text.begin()));
    begin = std::find_if(end, text.end(), is_letter);
  }
}

/// Calls `visit` with each word of Latin letters, as visit_words() does: in `LevelL` and `BBlower` these are `Level`
/// and `L`, `B` and `Blower`.
template <class Visit>
void visit_latin_words(std::string_view text, Visit visit) {
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  const auto is_small = [](char c) { return c >= 'a' && c <= 'z'; };
  visit_words(text, [&](std::string_view run, std::size_t at) {
    if (has_foreign(run)) return;
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= run.size(); ++i) {
      const bool ends = i == run.size() ||
                        (is_capital(run[i]) && (is_small(run[i - 1]) || (i + 1 < run.size() && is_small(run[i + 1]))));
      if (!ends) continue;
      visit(run.substr(begin, i - begin), at + begin);
      begin = i;
    }
  });
}

/// A text with Latin capitals for the letters of Cyrillic and Greek that look like them.
std::string with_latin_letters(std::string_view text) {
  constexpr std::u32string_view kAlike = U"АВЕКМНОРСТУХΑΒΕΖΗΙΚΜΝΟΡΤΥΧ";
  constexpr std::string_view kLatin = "ABEKMHOPCTYXABEZHIKMNOPTYX";
  std::string latin;
  for (std::size_t at = 0; at < text.size();) {
    const text::CodePoint letter = text::code_point_at(text, at);
    const std::size_t alike = kAlike.find(letter.value);
    latin += alike == kAlike.npos ? text.substr(at, letter.length) : kLatin.substr(alike, 1);
    at += letter.length;
  }
  return latin;
}

void letters_alike(const Find& find) {
  std::map<std::string, std::vector<const Symbol*>> others;  // by the word in Latin letters
  for (const Symbol& symbol : find.symbols) {
    if (!has_foreign(symbol.name())) continue;
    visit_words(symbol.name(), [&](std::string_view word, std::size_t) {
      const std::string latin = has_foreign(word) ? text::to_upper(with_latin_letters(word)) : "";
      if (!latin.empty() && !has_foreign(latin)) others[latin].push_back(&symbol);
    });
  }
  for (const Symbol& symbol : find.symbols) {
    if (others.empty()) return;
    visit_words(symbol.name(), [&](std::string_view word, std::size_t) {
      const auto found = others.find(text::to_upper(word));
      if (found == others.end()) return;
      const std::vector<const Symbol*>& alike = found->second;
      Finding finding = find.at(*alike.front());
      for (const Symbol* each : alike) finding.rename(*each, with_latin_letters(each->name()), true);
      finding.see(symbol, "in Latin letters")
          .say("`{}`{} Cyrillic or Greek letters that look like the Latin `{}` of `{}`; write it in one script",
               alike.front()->name(), alike.size() == 1 ? " has" : fmt::format(" and {} more have", alike.size() - 1),
               word, symbol.name());
      others.erase(found);
    });
  }
}

/// A word of Latin letters in names and comments.
struct Word {
  std::size_t count = 0;  ///< in all rows, internal ones too
  const read::ListRow* row = nullptr;
  std::string_view as_written;
  const Symbol* used_by = nullptr;  ///< the first input or output
};

/// Of 5 to 32 letters: shorter words that are near each other are often two words.
text::ByName<Word> words_of(const PlantModel& plant) {
  text::ByName<Word> words;
  auto next = plant.symbols.begin();  // in the order of lists and rows
  for (const model::PlantList& list : plant.lists) {
    for (const read::ListRow& row : list.table->rows) {
      const bool is_io = next != plant.symbols.end() && next->row == &row;
      const Symbol* symbol = is_io ? &*next++ : nullptr;
      const auto add = [&](std::string_view run, std::size_t) {
        if (run.size() < 5 || run.size() > 32) return;
        Word& word = words[run];
        const bool first_use = word.used_by == nullptr && symbol != nullptr;
        if (word.count++ == 0 || first_use) word = {word.count, &row, run, symbol};
      };
      if (!row.is_named_by_address()) visit_latin_words(row.name, add);
      visit_latin_words(row.comment, add);
    }
  }
  return words;
}

/// Whether an inner letter is missing in one of two near words, or two are exchanged. Else they may be two words.
bool are_one_word(std::u32string_view a, std::u32string_view b) {
  return a.front() == b.front() && a.back() == b.back() && !differ_by_another_letter(a, b);
}

void two_spellings(const Find& find) {
  const text::ByName<Word> words = words_of(find.plant);
  std::map<std::u32string, const Word*> sorted;
  for (const auto& [word, of] : words) sorted.emplace(capitals(word), &of);
  std::vector<CountedWord> counted;
  counted.reserve(sorted.size());
  for (const auto& [word, of] : sorted) counted.push_back({word, of->count});
  const NearWords near(counted);
  std::map<std::string, std::pair<std::string_view, Finding>> found;  // by the rarer spelling, in capitals
  for (const auto& [word, count] : counted) {
    const Word& rare = *sorted[word];
    if (rare.used_by == nullptr) continue;
    for (const std::uint32_t other : near.near(word)) {
      const Word& common = *sorted[counted[other].text];
      const bool is_rarer = std::tuple(count, counted[other].text) < std::tuple(common.count, word);
      if (common.count < 2 || !is_rarer || !are_one_word(word, counted[other].text)) continue;
      Finding finding = find.at(location_of(find.plant, *rare.row, rare.as_written));
      finding.also(Kind::symbol, rare.as_written).also(Kind::symbol, rare.used_by->name());
      finding.see(*common.row, common.as_written, "the other spelling");
      // SP205 says which one is meant.
      if (find.plant.pairing == nullptr) finding.follows(Kind::device, rare.used_by->reading.device_path());
      found.emplace(text::to_upper(rare.as_written), std::pair(common.as_written, std::move(finding)));
      break;
    }
  }
  for (const Symbol& symbol : find.symbols) {
    if (found.empty()) break;
    visit_latin_words(symbol.name(), [&](std::string_view word, std::size_t at) {
      const auto known = found.find(text::to_upper(word));
      if (known == found.end()) return;
      known->second.second.rename(symbol, std::string(symbol.name()).replace(at, word.size(), known->second.first));
    });
  }
  for (auto& [rare, of] : found) {
    const std::size_t count = words.find(rare)->second.count;
    of.second.say("`{}` ({} time{}) and `{}` ({} times) look like one word; write it alike everywhere", rare, count,
                  count == 1 ? "" : "s", text::to_upper(of.first), words.find(of.first)->second.count);
  }
}

/// The last word of a text, in capitals; empty if the text ends otherwise or in another script.
std::string last_word(std::string_view text) {
  std::string last;
  visit_words(text, [&](std::string_view word, std::size_t at) {
    if (at + word.size() == text.size() && !has_foreign(word)) last = text::to_upper(word);
  });
  return last;
}

void text_cut(const Find& find) {
  std::vector<std::map<std::size_t, std::vector<const Symbol*>>> lists(find.plant.lists.size());
  for (const Symbol& symbol : find.symbols) {
    lists[symbol.list][text::count_code_points(symbol.row->comment)].push_back(&symbol);
  }
  for (const auto& by_length : lists) {
    if (by_length.empty() || by_length.rbegin()->first < 15) continue;  // fields are longer
    auto [length, longest] = *by_length.rbegin();
    if (longest.size() < 3) continue;
    text::ByName<bool> others;  // words that do not end one of the longest comments
    for (const auto& [other, symbols] : by_length) {
      for (const Symbol* symbol : symbols) {
        const std::string_view comment = symbol->row->comment;
        visit_words(comment, [&, all = other != length](std::string_view word, std::size_t at) {
          if (all || at + word.size() != comment.size()) others.try_emplace(word, true);
        });
      }
    }
    std::set<std::string> words;
    for (const auto& [word, is_other] : others) words.insert(text::to_upper(word));
    std::erase_if(longest, [&](const Symbol* symbol) {
      const std::string last = last_word(symbol->row->comment);
      const auto next = words.lower_bound(last);
      return last.empty() || next == words.end() || *next == last || !next->starts_with(last);
    });
    if (longest.size() < 3) continue;
    const read::ListRow& row = *longest.front()->row;
    find.at(location_of(find.plant, row, row.comment))
        .also(Kind::symbol, row.name)
        .say("{} comments end after {} characters within a word, such as `{}`: they are cut; shorten them",
             longest.size(), length, row.comment);
  }
}

constexpr Rule kTextRules[] = {
    {"SP210", "letters-alike", kWarning, letters_alike, "words in letters of two scripts that look alike",
     "A name has a word in Cyrillic or Greek letters, and another name has it in Latin ones: `КА12` and `KA2`.",
     "The symbols of one device become two devices, and patterns read only some of them.",
     "Write it in Latin letters. In naming.json, `\"replace\": [[\"КА\", \"KA\"]]` makes them equal.", Rank::name},
    {"SP211", "two-spellings", kWarning, two_spellings, "one word is spelled in two forms",
     "`SAFTY` and `SAFETY`, `NORMAL` and `NOMAL`: an inner letter is missing, or two are exchanged.",
     "A pattern with one spelling does not match the other.",
     "Write one everywhere. In naming.json, `\"replace\": [[\"SAFTY\", \"SAFETY\"]]` makes them equal."},
    {"SP212", "text-cut", kWarning, text_cut, "comments end at the length limit of a field",
     "Several of the longest comments have one length and end with the beginning of a word that others have. An "
     "engineering tool or an export cut them: GX Works keeps 32 characters.",
     "The end, which often says what a signal means: `forward end`, `forward start`.",
     "Shorten the comments, or export them with a longer field."},
};

}  // namespace

std::span<const Rule> text_rules() { return kTextRules; }

}  // namespace symplant::check

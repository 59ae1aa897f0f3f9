// Rules: names that look misspelled.
#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "check/rule.hpp"
#include "check/words.hpp"
#include "text/ascii.hpp"
#include "text/shape.hpp"

namespace symplant::check {
namespace {

/// Of the three parts of a name that are compared: its line, its process, or the rest.
std::string_view part_of(const Symbol& symbol, std::size_t part) {
  const std::size_t line = symbol.reading.line().size();
  const std::size_t process = symbol.reading.process().size();
  if (part != 2) return part == 0 ? symbol.name().substr(0, line) : symbol.name().substr(line + 1, process);
  return symbol.name().substr(line + process + 2);
}

/// A text like another one, with the numbers of a third: `CLAMP12` for `CLAMP1` and `CLAPM12`.
std::string with_numbers_of(std::string_view like, std::string_view numbers) {
  std::string text;
  std::size_t end = 0;
  for (const char c : text::shape_of(like)) {
    const std::size_t begin = c == '#' ? std::min(numbers.find_first_of("0123456789", end), numbers.size()) : 0;
    if (c == '#') end = std::min(numbers.find_first_not_of("0123456789", begin), numbers.size());
    text += c == '#' ? std::string(numbers.substr(begin, end - begin)) : std::string(1, c);
  }
  return text;
}

/// A name's line, process and device.
std::string_view device_of(std::string_view name) {
  return name.substr(0, name.find('_', name.find('_', name.find('_') + 1) + 1));
}

/// Whether a state has only an operation or only an event.
bool is_half(const State& state) { return (state.operation == kNone) != (state.event == kNone); }

class Slips {
 public:
  explicit Slips(const Find& find) : find_(find) {
    for (const Unit& unit : find.units) {
      for (const State& state : unit.states) {
        if (!is_half(state)) continue;
        const Direction lacks = state.event == kNone ? Direction::event : Direction::operation;
        missing_[text::to_upper(symbol_name(unit.path, lacks, state.name))] =
            !unit.operations.empty() && !unit.events.empty();
      }
    }
  }

  /// Looks for names with a rare part that is near a common one, or one that completes a device.
  void compare(std::size_t part) {
    std::unordered_map<std::string, std::size_t> index;
    std::vector<CountedWord> words;                   // texts that are equal, digits apart
    std::vector<std::string> like;                    // one of them
    std::vector<std::vector<const Symbol*>> symbols;  // which have it
    texts_ = {};
    std::string_view last;
    std::size_t place = 0;  // of the last one: names next to each other often have one line and process
    const auto add = [&](std::string_view text, const Symbol* symbol) {
      if (std::exchange(last, text) != text || words.empty()) {
        const std::string word = class_name(text);
        place = index.try_emplace(word, words.size()).first->second;
        if (place == words.size()) {
          words.push_back({capitals(word), 0});
          ++texts_[first_level(words.back().text)];
          like.emplace_back(text);
          symbols.emplace_back();
        }
      }
      if (symbol == nullptr) return;
      ++words[place].count;
      symbols[place].push_back(symbol);
    };
    for (const Symbol& symbol : find_.symbols) {
      if (!symbol.reading.is_named() || symbol.described || symbol.named != symbol.direction) continue;
      add(part_of(symbol, part), &symbol);
    }
    for (const auto& [name, has_side] : missing_) {
      if (part == 2 && has_side) add(std::string_view(name).substr(device_of(name).rfind('_') + 1), nullptr);
    }
    const NearWords near(words);
    for (std::size_t i = 0; i < words.size(); ++i) {
      for (const std::uint32_t other : near.near(words[i].text)) {
        if (!may_be_slip(words[i], words[other])) continue;
        std::erase_if(symbols[i], [&](const Symbol* symbol) {
          const std::string_view text = part_of(*symbol, part);
          const auto at = static_cast<std::size_t>(text.data() - symbol->name().data());
          const std::string meant = with_numbers_of(like[other], text);
          return report(*symbol, std::string(symbol->name()).replace(at, text.size(), meant), words[i], words[other]);
        });
      }
    }
  }

  /// Of devices that differ in a line or process and lack a side of a task, looks for two that complete each other.
  void complete() {
    std::map<std::string, std::vector<const Unit*>> groups;  // by the other levels
    for (const Unit& unit : find_.units) {
      if (std::ranges::none_of(unit.states, is_half) || slipped_.count(unit.path) != 0) continue;
      const model::SymbolReading& reading = find_.symbols[unit.first_symbol()].reading;
      groups[text::to_upper(fmt::format("{}_?_{}", reading.line(), reading.device()))].push_back(&unit);
      groups[text::to_upper(fmt::format("?_{}_{}", reading.process(), reading.device()))].push_back(&unit);
    }
    for (const auto& [rest, units] : groups) {
      // Of three it is not known which belong together.
      if (units.size() != 2 || class_name(units[0]->path) == class_name(units[1]->path)) continue;
      if (!complete(*units[1], *units[0])) complete(*units[0], *units[1]);
    }
  }

  void say() {
    for (auto& [key, finding] : findings_) find_.diagnostics.add(std::move(finding.as));
  }

 private:
  /// Whether the list has a symbol or a device, in any case of letters.
  bool has(std::string_view name) {
    if (known_.empty()) {
      for (const Symbol& symbol : find_.symbols) {
        known_.insert({{symbol.name(), true}, {symbol.reading.device_path(), true}});
      }
    }
    return known_.count(name) != 0;
  }

  static std::string other_side_of(const Symbol& symbol) {
    return symbol_name(symbol.reading.device_path(), other_side(symbol.direction), symbol.reading.task());
  }

  static bool may_be_slip(const CountedWord& rare, const CountedWord& common) {
    if (rare.count > common.count + 1 || differ_by_ending(rare.text, common.text)) return false;  // SP405 reports it
    const bool another = rare.text.size() == common.text.size();
    return common.count >= 8 * rare.count || !another || !may_be_codes(rare.text, common.text);
  }

  /// Whether a symbol was meant to have another name, by two near texts in them.
  bool report(const Symbol& symbol, const std::string& meant, const CountedWord& rare, const CountedWord& common) {
    const std::string other_side = other_side_of(symbol);
    if (has(meant) || text::equal_ignoring_case(meant, other_side)) return false;
    const std::string_view path = device_of(meant);
    const bool device = has(path);
    const bool whole = rare.count == 1 && texts_[first_level(rare.text)] == 1;  // all of a line, process or device
    const bool codes = !whole && may_be_codes(rare.text, common.text);
    const bool is_rare = common.count >= (device && !codes ? 3 : 8) * rare.count && (device || !codes);
    // A NIGHT is commanded, a LIGHT is reported: they are complete.
    const auto missing = missing_.find(text::to_upper(meant));
    const bool own_task = text::equal_ignoring_case(path, symbol.reading.device_path());
    const bool completes = missing != missing_.end() && missing->second && !has(other_side) && (own_task || !codes);
    if (!is_rare && !completes) return false;
    missing_.erase(text::to_upper(meant));
    missing_.erase(text::to_upper(other_side));
    add(symbol, meant, device,
        device ? fmt::format(", and `{}` lacks just this symbol", path)
               : fmt::format(", which {} symbols have if digits are ignored", common.count));
    return true;
  }

  /// Whether the symbols of one unit are just those that another one lacks: two or more, or one where the other has a
  /// state with both sides.
  bool complete(const Unit& part, const Unit& whole) {
    std::vector<std::pair<const Symbol*, std::string>> renamed;
    for (const auto* symbols : {&part.operations, &part.events}) {
      for (const std::uint32_t symbol : *symbols) {
        const std::string_view name = find_.symbols[symbol].name();
        renamed.emplace_back(&find_.symbols[symbol], std::string(whole.path).append(name.substr(part.path.size())));
        if (missing_.count(text::to_upper(renamed.back().second)) == 0) return false;
      }
    }
    const auto lacking = static_cast<std::size_t>(std::ranges::count_if(whole.states, is_half));
    const bool single = lacking < 2 && whole.operations.size() + whole.events.size() == lacking;
    if (renamed.size() != lacking || single) return false;
    for (const auto& [symbol, name] : renamed) {
      add(*symbol, name, false, fmt::format(", or the reverse: `{}` has just what `{}` lacks", part.path, whole.path));
    }
    return true;
  }

  /// One finding for all symbols with one slip up to it.
  void add(const Symbol& symbol, const std::string& meant, bool safe, const std::string& why) {
    std::size_t begin = 0;  // of the word that differs
    std::string_view written;
    std::string word;
    for (;; begin += written.size() + 1) {
      written = symbol.name().substr(begin, symbol.name().find('_', begin) - begin);
      word = meant.substr(begin, meant.find('_', begin) - begin);
      if (!text::equal_ignoring_case(written, word)) break;
    }
    const std::string key = text::to_upper(fmt::format("{} {}", symbol.name().substr(0, begin + written.size()), word));
    const auto [known, added] = findings_.try_emplace(key, find_.at(symbol));
    Finding& finding = known->second;
    if (added) {
      text::Span& span = finding.as.location.span;
      if (span.end - span.begin == symbol.name().size()) {
        span = {span.begin + begin, span.begin + begin + written.size()};
      }
      finding.also(Kind::device, device_of(meant));
      finding.as.message =
          fmt::format("`{0}` looks like a typo of `{1}`{2}; write `{1}` if that is meant", written, word, why);
    } else {
      finding.also(Kind::symbol, symbol.name()).see(symbol, "here too");
    }
    finding.rename(symbol, meant, safe).explains(Kind::device, symbol.reading.device_path());
    finding.lacks(meant, device_of(meant));
    slipped_.insert(symbol.reading.device_path());
  }

  static std::u32string first_level(const std::u32string& text) { return text.substr(0, text.find(U'_')); }

  const Find& find_;
  std::map<std::u32string, std::size_t> texts_;  ///< by their first level: how many are compared
  text::ByName<bool> known_;
  std::map<std::string, bool> missing_;  ///< other sides of symbols; whether their devices have that side at all
  std::map<std::string, Finding> findings_;
  std::set<std::string_view> slipped_;  ///< devices
};

void name_slip(const Find& find) {
  Slips slips(find);
  for (std::size_t part = 0; part < 3; ++part) slips.compare(part);
  slips.complete();
  slips.say();
}

constexpr Rule kSpellingRules[] = {
    {"SP205", "name-slip", kWarning, name_slip, "a word in a name looks like a typo of the one that is meant",
     "A line, process, device or task has one letter added, missing or changed, or two exchanged: `CLAPM1` for "
     "`CLAMP1`. "
     "Digits, letters of short codes (`PB1`, `PL1`), axes and sides (`PBLX`, `PBLY`) are no slip. The list gives "
     "evidence:\n- The device that is meant lacks just this symbol: its siblings have it (`CLAMP2`), or its "
     "counterpart "
     "is there.\n- The word is rare, and the one that is meant is eight times as common.\n- One of two devices that "
     "differ in line or process has just what the other lacks: `EXCELL_MB_AGV` and `EXLINE_MB_AGV`.",
     "The symbol becomes another device or state, and the device that is meant lacks it.",
     "Write the word that is meant. If both are meant, ignore the finding in plant.json.", Rank::name, For::levels},
};

}  // namespace

std::span<const Rule> spelling_rules() { return kSpellingRules; }

}  // namespace symplant::check

// Chooses and prepares the texts of samples for a report.
#include "infer/report_texts.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "infer/words.hpp"
#include "name/prepared_text.hpp"
#include "name/required_words.hpp"
#include "name/vocabulary.hpp"
#include "text/utf8.hpp"

namespace symplant::infer {
namespace {

constexpr std::size_t kMostShown = 80;  ///< bytes

/// What the pattern of a symbol's rule reads first.
name::Source source_of(const name::Naming& naming, const name::Reading& reading) {
  const name::Source source = naming.rules[reading.rule].patterns.front().source;
  return source == name::Source::name_then_comment ? name::Source::name : source;
}

name::Replacements replacements_of(const name::Naming& naming) {
  std::vector<std::pair<std::size_t, std::string>> faults;  // none: the rule is compiled
  return {naming.normalise.replace, faults};
}

std::string without_digits(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text.append(shape_of(word)).append(" ");
  return text;
}

/// The lists of words that make a kind, by what has to be looked for.
class KindWords {
 public:
  KindWords() {
    const name::BuiltInWords& known = name::built_in_words();
    add(kPanelText, known.panel);
    add(kInterlockText, known.interlock);
    add(kStartText, known.start);
    add(kDoneText, known.done);
    add(kAnswerText, known.echo);
    add(kAnswerText, known.reset);
    add(kHealthyText, known.healthy);
    add(kAlarm, known.alarm);
  }

  std::uint8_t of(const std::vector<std::string>& words, const name::Vocabulary& vocabulary) const {
    unsigned kinds = 0;
    bool ascii = true;
    const auto look_for = [&](const Words& list) {
      for (const auto& [word, kind] : list) kinds |= contains(words, word, vocabulary) ? kind : 0U;
    };
    for (const std::string& word : words) {
      ascii = ascii && std::all_of(word.begin(), word.end(), [](char c) { return static_cast<signed char>(c) >= 0; });
      const auto found = words_.find(std::string_view(word).substr(0, word.find_last_not_of("0123456789") + 1));
      if (found == words_.end()) continue;
      kinds |= found->second.kinds;
      look_for(found->second.phrases);
    }
    if (!ascii) look_for(within_);
    if ((kinds & kAlarm) != 0) kinds &= ~unsigned{kHealthyText};
    return static_cast<std::uint8_t>(kinds & ~kAlarm);
  }

 private:
  static constexpr unsigned kAlarm = 64;
  using Words = std::vector<std::pair<std::string_view, unsigned>>;
  struct Found {
    unsigned kinds = 0;
    Words phrases;  ///< that begin with the word
  };

  void add(unsigned kind, std::span<const std::string_view> list) {
    for (const std::string_view known : list) {
      const std::size_t blank = known.find(' ');
      if (blank != std::string_view::npos) {
        words_[known.substr(0, blank)].phrases.emplace_back(known, kind);
      } else if (text::code_point_at(known, 0).value >= name::kFirstWithoutBlanks) {
        within_.emplace_back(known, kind);
      } else {
        words_[known].kinds |= kind;
      }
    }
  }

  std::unordered_map<std::string_view, Found> words_;
  Words within_;  ///< of scripts without blanks
};

}  // namespace

ReportTexts::ReportTexts(const name::CompiledNaming& naming, std::span<const Sample> samples,
                         std::span<const name::Reading> readings)
    : naming_(naming),
      samples_(samples),
      separators_(naming.naming().separators),
      replacements_(replacements_of(naming.naming())),
      sources_(samples.size(), name::Source::name),
      kinds_(samples.size()) {
  std::array<std::size_t, 4> counts{};
  const auto is_read = [&](std::size_t i) { return readings[i].is_read(); };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (is_read(i)) ++counts[static_cast<std::size_t>(source_of(naming.naming(), readings[i]))];
  }
  const auto usual = static_cast<name::Source>(std::max_element(counts.begin() + 1, counts.end()) - counts.begin());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const name::Source source = is_read(i) ? source_of(naming.naming(), readings[i]) : usual;
    if (!samples[i].text.comment.empty() || !samples[i].text.parent_comment.empty()) sources_[i] = source;
  }
}

std::string ReportTexts::raw(std::uint32_t sample) const {
  const name::SymbolText& text = samples_[sample].text;
  if (sources_[sample] == name::Source::name) return std::string(text.name);
  std::string both;
  if (sources_[sample] == name::Source::parent_and_comment) both = text.parent_comment;
  both.append(both.empty() || text.comment.empty() ? "" : " ").append(text.comment);
  return both;
}

std::string ReportTexts::normal(std::uint32_t sample) const {
  std::string text = name::normalised(raw(sample), naming_.naming().normalise, naming_.vocabulary(), separators_);
  replacements_.apply(text);
  return text;
}

std::string ReportTexts::shown(std::uint32_t sample) const {
  std::string text;
  for (const char c : raw(sample)) {
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!blank) {
      text += c;
    } else if (!text.empty() && text.back() != ' ') {
      text += ' ';
    }
  }
  if (text.size() <= kMostShown) return text;
  std::size_t end = kMostShown;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end) + "...";
}

std::vector<std::string> ReportTexts::words(std::uint32_t sample) const {
  name::PreparedText text;
  text.prepare(normal(sample), separators_);
  std::vector<std::string> words;
  words.reserve(text.words().size());
  for (const name::Word& word : text.words()) {
    words.emplace_back(text.folded().substr(word.begin, word.end - word.begin));
  }
  return words;
}

std::uint8_t ReportTexts::kinds(std::uint32_t sample) {
  static const KindWords kWords;
  std::optional<std::uint8_t>& kinds = kinds_[sample];
  if (kinds) return *kinds;
  const std::vector<std::string> own = words(sample);
  const auto [known, added] = kinds_of_words_.emplace(without_digits(own), std::uint8_t{0});
  if (added) known->second = kWords.of(own, naming_.vocabulary());
  kinds = known->second;
  return *kinds;
}

}  // namespace symplant::infer

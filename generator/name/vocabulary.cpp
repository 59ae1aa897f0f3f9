// Looks up words of a naming rule.
#include "name/vocabulary.hpp"

#include <algorithm>

#include "text/ascii.hpp"
#include "text/folding.hpp"

namespace symplant::name {
namespace {

std::size_t words_in(std::string_view text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), ' ')) + 1;
}

/// Single letters and digits fused with a word are no affixes.
constexpr std::size_t kLeastFused = 2;

}  // namespace

Vocabulary::Vocabulary(const TaskRules& rules, const std::vector<DirectionWord>& classes) {
  for (const DirectionWord& word : classes) classes_.emplace(keep(text::folded(word.word)), word.says);
  if (rules.vocabulary) add_built_in(built_in_words());
  for (const auto& [rest, other] : rules.pairs) add_pair(rest, other, false);
  for (const auto& [words, canonical] : rules.synonyms) add_synonym(words, canonical);
  for (const std::string& word : rules.operation_affixes) add_affix(Direction::operation, word);
  for (const std::string& word : rules.event_affixes) add_affix(Direction::event, word);
  std::stable_sort(fused_affixes_.begin(), fused_affixes_.end(),
                   [](std::string_view a, std::string_view b) { return a.size() > b.size(); });
}

void Vocabulary::add_built_in(const BuiltInWords& words) {
  for (const BuiltInWords::Pair& pair : words.pairs) add_pair(pair.rest, pair.other, pair.noun);
  for (const BuiltInWords::Synonym& synonym : words.synonyms) add_synonym(synonym.words, synonym.canonical);
  for (const std::string_view word : words.operation_affixes) add_affix(Direction::operation, word);
  for (const std::string_view word : words.event_affixes) add_affix(Direction::event, word);
  for (const BuiltInWords::ClassWord& word : words.classes) classes_.emplace(word.word, word.side);
}

std::string_view Vocabulary::keep(std::string text) { return *kept_.insert(std::move(text)).first; }

std::string_view Vocabulary::fold(std::string_view text) { return keep(text::folded(text::normal_form(text))); }

void Vocabulary::add_pair(std::string_view rest, std::string_view other, bool noun) {
  const std::string_view rest_word = fold(rest);
  const std::string_view other_word = fold(other);
  const Entry* known_rest = entry(rest_word);
  const Entry* known_other = entry(other_word);
  const bool one_pair = known_rest != nullptr && known_other != nullptr && known_rest->pair == known_other->pair &&
                        known_rest->rest != known_other->rest;
  std::uint32_t pair = 0;
  if (one_pair || (known_rest == nullptr) != (known_other == nullptr)) {  // joins a pair, which may turn round
    pair = known_rest != nullptr ? known_rest->pair : known_other->pair;
    const bool turned = known_rest != nullptr ? !known_rest->rest : known_other->rest;
    for (auto& [word, known] : motions_) known.rest = known.rest != (turned && known.pair == pair);
  } else {
    pair = static_cast<std::uint32_t>(pairs_.size());
    pairs_.emplace_back();
  }
  pairs_[pair] = {keep(std::string(rest)), keep(std::string(other))};
  motions_.insert_or_assign(rest_word, Entry{pair, true, false});
  motions_.insert_or_assign(other_word, Entry{pair, false, noun});
}

void Vocabulary::add_synonym(std::string_view words, std::string_view canonical) {
  const std::string_view folded = fold(words);
  const std::size_t count = words_in(folded);
  const Entry* meant = entry(fold(canonical));
  if (count == 1 && meant != nullptr) {
    motions_.insert_or_assign(folded, Entry{meant->pair, meant->rest, false});
    return;
  }
  synonyms_.insert_or_assign(folded, keep(std::string(canonical)));
  starts_.insert(folded.substr(0, folded.find(' ')));
  longest_synonym_ = std::max(longest_synonym_, count);
}

void Vocabulary::add_affix(Direction side, std::string_view word) {
  const std::string_view folded = fold(word);
  auto& words = side == Direction::operation ? operation_affixes_ : event_affixes_;
  if (words.insert(folded).second && folded.size() >= kLeastFused) fused_affixes_.push_back(folded);
}

const Vocabulary::Entry* Vocabulary::entry(std::string_view folded) const {
  const auto found = motions_.find(folded);
  return found == motions_.end() ? nullptr : &found->second;
}

std::optional<Motion> Vocabulary::motion(std::string_view folded) const {
  std::size_t end = folded.size();
  const auto found = [&](const Entry& known) {
    const Pair& pair = pairs_[known.pair];
    return Motion{
        known.rest ? pair.rest : pair.other, pair.rest, known.pair, known.rest, known.noun, folded.substr(end)};
  };
  if (const Entry* known = entry(folded)) return found(*known);  // also a word with digits, such as `90`
  while (end > 0 && text::is_digit(folded[end - 1])) --end;
  const std::string_view stem = folded.substr(0, end);
  if (const Entry* known = entry(stem)) return found(*known);
  for (const std::string_view affix : fused_affixes_) {
    if (stem.size() <= affix.size()) continue;
    if (stem.ends_with(affix)) {
      if (const Entry* known = entry(stem.substr(0, stem.size() - affix.size()))) return found(*known);
    }
    if (stem.starts_with(affix)) {
      if (const Entry* known = entry(stem.substr(affix.size()))) return found(*known);
    }
  }
  return std::nullopt;
}

bool Vocabulary::is_affix(std::string_view folded, Direction side) const {
  return (side == Direction::operation ? operation_affixes_ : event_affixes_).contains(folded);
}

std::string_view Vocabulary::synonym(std::string_view folded_words) const {
  const auto found = synonyms_.find(folded_words);
  return found == synonyms_.end() ? std::string_view() : found->second;
}

std::optional<Said> Vocabulary::class_said(std::string_view folded) const {
  const auto found = classes_.find(folded);
  if (found == classes_.end()) return std::nullopt;
  return found->second;
}

bool Vocabulary::knows(std::string_view folded) const {
  return motion(folded).has_value() || classes_.contains(folded) || starts_.contains(folded) ||
         operation_affixes_.contains(folded) || event_affixes_.contains(folded);
}

}  // namespace symplant::name

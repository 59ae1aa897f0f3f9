// Looks for healthy words at the ends of names and comments.
#include "score/questions.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "name/naming_parts.hpp"
#include "name/vocabulary.hpp"
#include "text/folding.hpp"

namespace symplant::score {
namespace {

/// The healthy words of the vocabulary, cut into words as the naming rule cuts texts.
class HealthyWords {
 public:
  explicit HealthyWords(const name::Separators& separators) {
    name::PreparedText text;
    const auto& healthy = name::built_in_words().healthy;
    for (std::size_t i = 0; i < healthy.size(); ++i) {
      text.prepare(text::normal_form(healthy[i]), separators);
      Phrase phrase{i, words_of(text)};
      by_last_[phrase.words.back()].push_back(std::move(phrase));
    }
  }

  /// The index of the longest one at the end of a text.
  std::optional<std::size_t> at_end(const name::PreparedText& text) const {
    if (text.words().empty()) return std::nullopt;
    const name::Word& last = text.words().back();
    const auto found = by_last_.find(std::string(text.folded().substr(last.begin, last.end - last.begin)));
    if (found == by_last_.end()) return std::nullopt;
    const std::vector<std::string> words = words_of(text);
    const Phrase* longest = nullptr;
    for (const Phrase& phrase : found->second) {
      const bool longer = longest == nullptr || phrase.words.size() > longest->words.size();
      if (longer && phrase.words.size() <= words.size() &&
          std::equal(phrase.words.rbegin(), phrase.words.rend(), words.rbegin())) {
        longest = &phrase;
      }
    }
    return longest == nullptr ? std::nullopt : std::optional(longest->index);
  }

 private:
  struct Phrase {
    std::size_t index;
    std::vector<std::string> words;
  };

  static std::vector<std::string> words_of(const name::PreparedText& text) {
    std::vector<std::string> words;
    for (const name::Word& word : text.words()) {
      words.emplace_back(text.folded().substr(word.begin, word.end - word.begin));
    }
    return words;
  }

  std::unordered_map<std::string, std::vector<Phrase>> by_last_;
};

/// Whether an answer could account for the symbol.
bool may_be_constant(const model::Symbol& symbol, Account account) {
  return symbol.direction == tables::Direction::event &&
         (account == Account::no_operation || account == Account::no_rule || account == Account::role_none);
}

}  // namespace

std::string Questions::rule() const {
  std::string all;  // no word of the vocabulary has a character that patterns or JSON read as syntax
  for (const std::string_view word : words) all.append(all.empty() ? "" : "|").append(word);
  const std::string side = by_address ? R"("side": "event", )" : "";
  return R"-({ "name": "healthy", )-" + side + R"-("pattern": "* ()-" + all +
         R"-()", "role": "constant", "value": true })-";
}

Questions questions_of(const model::PlantModel& plant, const PlantScore& score) {
  const name::NamingParts& parts = plant.reader->naming().parts();
  const HealthyWords healthy(parts.separators);
  const auto& known = name::built_in_words().healthy;
  std::vector<bool> found(known.size());
  Shapes shapes(plant);
  Questions questions;
  name::PreparedText text;
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    if (!may_be_constant(plant.symbols[i], score.accounts[i])) continue;
    for (const std::string_view written : {plant.symbols[i].name(), plant.symbols[i].row->comment}) {
      std::string normal = name::normalised(written, plant.naming().normalise, parts.vocabulary, parts.separators);
      parts.replace.apply(normal);
      text.prepare(normal, parts.separators);
      const auto word = healthy.at_end(text);
      if (!word) continue;
      found[*word] = true;
      shapes.add(i, score.accounts[i]);
      questions.by_address = questions.by_address && plant.symbols[i].address;
      break;
    }
  }
  questions.shapes = shapes.take();
  for (std::size_t w = 0; w < known.size(); ++w) {
    if (found[w]) questions.words.push_back(known[w]);
  }
  return questions;
}

}  // namespace symplant::score

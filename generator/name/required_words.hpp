// Words that a text must have for a rule.
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

#include "name/prepared_text.hpp"
#include "name/vocabulary.hpp"

namespace symplant::name {

inline constexpr char32_t kFirstWithoutBlanks = 0x2E80;  ///< from here on: scripts of East Asia

/// Words of which a text must have one. Words of scripts without blanks are also found within words.
class RequiredWords {
 public:
  RequiredWords(const std::vector<std::string>& words, const Separators& separators);

  bool empty() const { return words_.empty() && phrases_.empty() && inside_.empty(); }
  /// A word that is itself a motion of the vocabulary is not searched for other words.
  bool are_in(const PreparedText& text, const Vocabulary& vocabulary) const;

 private:
  std::unordered_set<std::string> words_;
  std::vector<std::string> phrases_;  ///< enclosed by blanks
  std::vector<std::string> inside_;
};

}  // namespace symplant::name

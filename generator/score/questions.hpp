// Events that are probably on in a healthy plant. The user is asked about them; they are never guessed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "score/shapes.hpp"

namespace symplant::score {

struct Questions {
  std::vector<Shape> shapes;            ///< the most frequent first
  std::vector<std::string_view> words;  ///< healthy words at the ends of the texts, in the order of the vocabulary
  bool by_address = true;               ///< an address says that each is an event

  /// For `rest` of naming.json: a rule that makes all these events constant.
  std::string rule() const;
};

/// Events that are not accounted for and whose name or comment ends in a healthy word. O(symbols).
Questions questions_of(const model::PlantModel& plant, const PlantScore& score);

}  // namespace symplant::score

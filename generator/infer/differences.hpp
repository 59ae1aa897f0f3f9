// Words by which operations differ from the events that report them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "infer/words.hpp"

namespace symplant::infer {

/// Operations and events whose texts are equal except for one run of words in each.
struct Difference {
  std::vector<std::string> operation;      ///< words that only the operations have; may be empty
  std::vector<std::string> event;          ///< words that only the events have; may be empty
  std::size_t support = 0;                 ///< operations
  std::size_t before = 0;                  ///< operations with words before the difference
  std::size_t after = 0;                   ///< operations with words after it
  std::optional<std::string> before_text;  ///< the words before it, separated by blanks, if all operations agree
  std::optional<std::string> after_text;
  std::uint32_t example_operation = 0;  ///< index in the words
  std::uint32_t example_event = 0;
};

struct DifferenceLimits {
  std::size_t least_support = 3;
  std::size_t least_common = 2;  ///< words that both texts must have
  std::size_t most_words = 2;    ///< of a run
  std::size_t fixed = 0;         ///< words at the beginning that are never part of a difference
};

/// The best supported first. Texts with more than two partners do not count. O(words).
std::vector<Difference> differences_of(const std::vector<SampleWords>& words, const name::Vocabulary& vocabulary,
                                       DifferenceLimits limits);

}  // namespace symplant::infer

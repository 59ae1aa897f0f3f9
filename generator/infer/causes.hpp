// Judges whether one side's words cause the other's.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "infer/differences.hpp"

namespace symplant::infer {

/// Whether `words` contain one of the words or phrases of a list of the vocabulary.
bool has_word(const std::vector<std::string>& words, std::span<const std::string_view> list,
              const name::Vocabulary& vocabulary);

enum class Cause : std::uint8_t {
  none,     ///< an alarm, a lamp, a healthy contact: nothing that an operation moves
  echo,     ///< the event repeats the operation
  ack,      ///< the operation repeats the event
  work,     ///< the operation starts what the event reports as done
  sides,    ///< words that only say the side
  unknown,  ///< the words do not show a cause: only their support counts
};
Cause cause_of(const Difference& difference, const name::Vocabulary& vocabulary);
/// Whether words or support are enough to link both sides.
bool is_credible(const Difference& difference, Cause cause);

}  // namespace symplant::infer

// Reads the words of a task: affixes, synonyms, the motion, the number of a sensor.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "name/naming.hpp"
#include "name/vocabulary.hpp"

namespace symplant::name {

/// A task in canonical words. The texts of TaskReading, owned.
struct ReadTask {
  std::string canonical;
  std::string group;
  std::string numbered_group;
  std::string index;
  std::uint32_t pair = kNoPair;
  bool rest = false;
};

/// `shown` and `folded` are the words of the task. O(words).
ReadTask read_task(const std::vector<std::string_view>& shown, const std::vector<std::string_view>& folded,
                   Direction side, const TaskRules& rules, const Vocabulary& vocabulary);

}  // namespace symplant::name

// Finds which events follow which operations within a device, by the words in which their tasks differ.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "name/vocabulary.hpp"

namespace symplant::infer {

/// A word of a task. Digits at the end of a word are a separate token, glued to it.
struct TaskToken {
  std::string word;  ///< folded
  bool glued = false;
};
std::vector<TaskToken> tokens_of(const std::vector<std::string>& words);

/// The task of one symbol.
struct Task {
  std::uint32_t sample = 0;
  std::uint32_t device = 0;
  std::size_t path_words = 0;  ///< words of the device's path
  bool operation = false;
  std::vector<TaskToken> tokens;
};

/// An operation and an event of one device.
struct TaskLink {
  std::uint32_t operation = 0;  ///< index in the tasks
  std::uint32_t event = 0;
};

/// Operations and events of a device whose tasks are equal except for these words.
struct TaskDifference {
  std::vector<std::string> operation;
  std::vector<std::string> event;
  bool causal = false;  ///< the words themselves say that the operation causes the event
  std::vector<TaskLink> links;
};

/// The smallest and most causal first. Tasks of more than nine words do not count. O(tasks) for devices of usual size.
std::vector<TaskDifference> task_differences(std::span<const Task> tasks, const name::Vocabulary& vocabulary);

/// Whether words end in one of the phrases.
bool ends_in(std::string_view words, std::span<const std::string_view> phrases);
bool is_one_of(std::string_view word, std::span<const std::string_view> list);

}  // namespace symplant::infer

// Keeps what is read from each text of a task once.
#pragma once

#include <deque>
#include <string_view>

#include "base/index_table.hpp"
#include "name/reading.hpp"
#include "text/ascii.hpp"

namespace symplant::name {

/// Many devices have the same tasks.
class TaskStore {
 public:
  /// The reading of a text on one side; a new one is made by `read(entry)`, which sets its texts. O(text).
  template <class Read>
  const TaskReading* find_or_add(std::string_view text, Direction side, Read read) {
    const std::uint64_t hash = text::hash_ignoring_case(text) + static_cast<std::uint64_t>(side);
    const auto next = static_cast<std::uint32_t>(tasks_.size());
    const std::uint32_t index = by_text_.find_or_add(
        hash, next, [&](std::uint32_t other) { return tasks_[other].side == side && tasks_[other].task.text == text; });
    if (index == next) read(tasks_.emplace_back(Entry{side, {}}).task);
    return &tasks_[index].task;
  }

 private:
  struct Entry {
    Direction side;
    TaskReading task;
  };

  std::deque<Entry> tasks_;
  base::IndexTable by_text_;
};

}  // namespace symplant::name

// Keeps texts once, and numbers them.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>

#include "base/index_table.hpp"

namespace symplant::name {

/// Keeps each text once.
class TextStore {
 public:
  std::string_view keep(std::string_view text) { return texts_[number(text)]; }
  /// Equal for equal texts, counted from 0.
  std::uint32_t number(std::string_view text) {
    const auto next = static_cast<std::uint32_t>(texts_.size());
    const std::uint32_t found = index_.find_or_add(std::hash<std::string_view>()(text), next,
                                                   [&](std::uint32_t other) { return texts_[other] == text; });
    if (found == next) texts_.emplace_back(text);
    return found;
  }

 private:
  std::deque<std::string> texts_;
  base::IndexTable index_;
};

}  // namespace symplant::name

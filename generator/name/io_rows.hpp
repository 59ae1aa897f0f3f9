// Rows of lists that are I/O although their address is internal or missing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "name/level_rule.hpp"

namespace symplant::name {

/// Patterns of rows by name or address, with `*` and `?`, and which rows they matched. Not thread-safe.
class IoRows {
 public:
  struct Pattern {
    std::string text;
    Direction direction{};
    std::string pointer;      ///< of the text in plant.json; empty: of the command line
    std::size_t matched = 0;  ///< rows
    std::string also = {};    ///< a row that a pattern of the other direction matches, too
  };

  void add(const std::vector<std::string>& patterns, Direction direction, std::string_view pointer);
  bool empty() const { return patterns_.empty(); }
  const std::vector<Pattern>& patterns() const { return patterns_; }

  /// The direction of the first pattern that matches a row; nothing if no pattern matches. O(patterns).
  std::optional<Direction> direction_of(std::string_view name, std::string_view vendor_address,
                                        std::string_view iec_address);

 private:
  std::vector<Pattern> patterns_;
};

}  // namespace symplant::name

// Conditions that start and stop a recording.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "symplant/condition/tree.hpp"
#include "symplant/trace/plant_names.hpp"

namespace symplant::record {

/// A condition of symbols that are read. A value.
class Trigger {
 public:
  explicit Trigger(condition::Tree tree) : tree_(std::move(tree)) {}

  /// `values`: by symbol, as in the plant's value slots. O(condition).
  bool holds(std::span<const std::uint64_t> values) const;

 private:
  condition::Tree tree_;
};

/// Reads a condition. What is wrong with it: its syntax, an unknown name, a name that is not that of a symbol, a symbol
/// that the link does not read. `is_read`: by symbol.
std::variant<Trigger, std::string> read_trigger(std::string_view text, const trace::PlantNames& names,
                                                const std::vector<bool>& is_read);

}  // namespace symplant::record

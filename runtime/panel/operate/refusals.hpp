// The actions of acts and steps that the plant refused; the other actions were done.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "symplant/scenario/scenario.hpp"

namespace symplant::panel {

/// The refusals of one order, or of one step of a scenario, from its notes. Used by one thread at a time.
class Refusals {
 public:
  /// `value`: of a scenario::kRefusedNote.
  void add(std::uint64_t value) { values_.push_back(value); }
  void clear() { values_.clear(); }
  bool empty() const { return values_.empty(); }

  /// A step without the refused actions. `index`: of the step within the acts.
  scenario::Step done_of(scenario::Step step, std::size_t index) const;
  /// The refusals of one step, each as the value of a scenario::kHandNote.
  const std::vector<std::uint64_t>& values() const { return values_; }
  /// Why the first one was refused.
  std::string_view words() const;

 private:
  std::vector<std::uint64_t> values_;
};

}  // namespace symplant::panel

// How much later one run is than another, over time.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "symplant/tables/time.hpp"

namespace symplant::compare {

/// The offset from EXPECTED's times to ACTUAL's. It changes with each pair of changes if one run follows the other.
class Offsets {
 public:
  explicit Offsets(tables::Time first) { steps_.push_back({std::numeric_limits<tables::Time>::min(), first}); }

  tables::Time last() const { return steps_.back().second; }
  /// Sets the offset from EXPECTED's time `from` on. `from` must not decrease from call to call.
  void add(tables::Time from, tables::Time offset) {
    if (offset != last()) steps_.push_back({from, offset});
  }

  /// Translates ACTUAL's times to EXPECTED's. Times must not decrease from call to call. O(steps) over all calls.
  class Translation {
   public:
    explicit Translation(const Offsets& offsets) : steps_(offsets.steps_) {}
    tables::Time operator()(tables::Time actual) {
      while (at_ + 1 < steps_.size() && steps_[at_ + 1].first + steps_[at_ + 1].second <= actual) ++at_;
      return actual - steps_[at_].second;
    }

   private:
    const std::vector<std::pair<tables::Time, tables::Time>>& steps_;
    std::size_t at_ = 0;
  };

 private:
  std::vector<std::pair<tables::Time, tables::Time>> steps_;
};

}  // namespace symplant::compare

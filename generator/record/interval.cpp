// How often a PLC is really read.
#include "record/interval.hpp"

#include <algorithm>

namespace symplant::record {

void Interval::add(Time distance) {
  last_[count_++ % kLast] = distance;
  all_.add(distance);
  std::array<Time, kLast> sorted = last_;
  const auto size = static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(count_, kLast));
  // The lower one of two: the first time that is too long is a gap.
  const auto median = sorted.begin() + (size - 1) / 2;
  std::nth_element(sorted.begin(), median, sorted.begin() + size);
  now_ = std::max(wanted_, *median);
}

Time Interval::reached() const { return count_ < kFewest ? wanted_ : reached(wanted_, all_.durations().p50); }

}  // namespace symplant::record

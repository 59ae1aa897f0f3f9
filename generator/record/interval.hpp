// How often a PLC is really read.
#pragma once

#include <array>
#include <cstddef>

#include "record/line.hpp"
#include "symplant/exec/histogram.hpp"

namespace symplant::record {

/// The interval of readings that a PLC reaches. Fast and slow answers come mixed: a median counts, never a single one.
/// Not thread-safe.
class Interval {
 public:
  /// Times from one image to the next that are needed to measure.
  static constexpr std::uint64_t kFewest = 5;

  explicit Interval(Time wanted) : wanted_(wanted) {}

  /// The time from the beginning of one image to that of the next, over one connection. O(kLast).
  void add(Time distance);

  /// The interval now: the median of the last times, at least the one that is wanted.
  Time now() const { return now_; }
  /// The interval of all together: the median if the PLC is slower than wanted. O(1), but slow.
  Time reached() const;
  std::uint64_t count() const { return count_; }

  /// The median if it is longer than wanted, and not only by the error of a measurement.
  static Time reached(Time wanted, Time median) { return median - median / 32 > wanted ? median : wanted; }

 private:
  static constexpr std::size_t kLast = 15;

  const Time wanted_;
  Time now_ = wanted_;
  std::array<Time, kLast> last_{};
  std::uint64_t count_ = 0;
  exec::Histogram all_;
};

}  // namespace symplant::record

// A histogram of durations of fixed size; one thread counts, any thread reads.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "symplant/tables/time.hpp"

namespace symplant::exec {

/// A number that one thread changes and any thread may read meanwhile.
class Counter {
 public:
  void add(std::uint64_t more) noexcept { value_.store(value() + more, std::memory_order_relaxed); }
  void set(std::uint64_t value) noexcept { value_.store(value, std::memory_order_relaxed); }
  std::uint64_t value() const noexcept { return value_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::uint64_t> value_{0};
};

/// The summary of a histogram, in nanoseconds. A quantile is at most 1/64 (1.6 %) above the exact value and never below
/// it; `max` is exact. All are 0 if nothing was counted.
struct Durations {
  std::uint64_t count = 0;
  tables::Time p50 = 0;
  tables::Time p99 = 0;
  tables::Time p999 = 0;
  tables::Time max = 0;
};

/// Counts durations over the whole range of tables::Time >= 0: exactly up to 64 ns, then in 64 buckets for each power
/// of two. 30 kB.
class Histogram {
 public:
  /// Only one thread may call it. A negative duration counts as 0. O(1).
  void add(tables::Time duration) noexcept {
    const auto value = static_cast<std::uint64_t>(duration < 0 ? 0 : duration);
    buckets_[bucket_of(value)].add(1);
    if (value > max_.value()) max_.set(value);
  }

  /// Any thread may call it, also while another one counts. O(buckets).
  Durations durations() const noexcept;

  /// The number of durations from `upper` / 2 to below `upper`, a power of two, in ns. The octave with `upper` 1 is
  /// that of 0 ns.
  struct Octave {
    std::uint64_t upper;
    std::uint64_t count;
  };
  /// The octaves that have durations, in ascending order. Any thread may call it. O(buckets).
  std::vector<Octave> by_octave() const;

 private:
  static constexpr int kFineBits = 6;
  static constexpr std::uint64_t kFine = std::uint64_t{1} << kFineBits;  ///< buckets of a power of two
  static constexpr std::size_t kBuckets = (63 - kFineBits + 1) * kFine;

  static constexpr std::size_t bucket_of(std::uint64_t value) noexcept {
    if (value < kFine) return value;
    const auto scale = static_cast<std::size_t>(std::bit_width(value)) - 1 - kFineBits;
    return scale * kFine + (value >> scale);
  }
  /// The longest duration of a bucket.
  static constexpr std::uint64_t last_of(std::size_t bucket) noexcept {
    if (bucket < kFine) return bucket;
    const std::size_t scale = bucket / kFine - 1;
    return ((bucket % kFine + kFine + 1) << scale) - 1;
  }

  std::array<Counter, kBuckets> buckets_{};
  Counter max_;
};

}  // namespace symplant::exec

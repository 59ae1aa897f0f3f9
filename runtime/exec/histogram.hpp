// How long things took: a histogram of fixed size, counted by one thread and read by any.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "symplant/tables/time.hpp"

namespace symplant::exec {

/// A number that one thread counts up and any may read meanwhile.
class Counter {
 public:
  void add(std::uint64_t more) noexcept { value_.store(value() + more, std::memory_order_relaxed); }
  void set(std::uint64_t value) noexcept { value_.store(value, std::memory_order_relaxed); }
  std::uint64_t value() const noexcept { return value_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::uint64_t> value_{0};
};

/// What a histogram comes to, in nanoseconds. A quantile is at most 1/64 (1.6 %) above the duration itself, never
/// below it; `max` is exact. All are 0 where nothing was counted.
struct Durations {
  std::uint64_t count = 0;
  tables::Time p50 = 0;
  tables::Time p99 = 0;
  tables::Time p999 = 0;
  tables::Time max = 0;
};

/// Counts durations from 0 to all that tables::Time holds: one by one up to 64 ns, then 64 buckets for each power of
/// two. 30 kB, whatever is counted.
class Histogram {
 public:
  /// By one thread. What is below 0 counts as 0. Costs the same for each.
  void add(tables::Time duration) noexcept {
    const auto value = static_cast<std::uint64_t>(duration < 0 ? 0 : duration);
    buckets_[bucket_of(value)].add(1);
    if (value > max_.value()) max_.set(value);
  }

  /// By any thread, while another one counts, too. Looks at every bucket.
  Durations durations() const noexcept;

 private:
  static constexpr int kFineBits = 6;
  static constexpr std::uint64_t kFine = std::uint64_t{1} << kFineBits;  ///< buckets of a power of two
  static constexpr std::size_t kBuckets = (63 - kFineBits + 1) * kFine;

  static constexpr std::size_t bucket_of(std::uint64_t value) noexcept {
    if (value < kFine) return value;
    const auto scale = static_cast<std::size_t>(std::bit_width(value)) - 1 - kFineBits;
    return scale * kFine + (value >> scale);
  }
  /// The longest duration that it counts.
  static constexpr std::uint64_t last_of(std::size_t bucket) noexcept {
    if (bucket < kFine) return bucket;
    const std::size_t scale = bucket / kFine - 1;
    return ((bucket % kFine + kFine + 1) << scale) - 1;
  }

  std::array<Counter, kBuckets> buckets_{};
  Counter max_;
};

}  // namespace symplant::exec

// The ranges of positions that clients read again and again, and how often.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "symplant/tables/time.hpp"

namespace symplant::link::image {

/// Keeps the ranges read last. One thread notes reads, another one asks; wait-free. Times are in ns, by the clock of
/// the thread that asks.
class ReadRanges {
 public:
  /// A range that was not read for this long is no longer read again and again.
  static constexpr tables::Time kForgotten = 60 * tables::kSecond;

  /// A request read this range, not empty, at `now`. O(kRanges).
  void read(std::uint32_t first, std::uint32_t count, tables::Time now) noexcept {
    const std::uint64_t key = std::uint64_t{first} << 32 | count;
    Range* oldest = &ranges_.front();
    for (Range& range : ranges_) {
      if (get(range.key) == key) return note(range, now);
      if (get(range.reads) == 0 || get(range.last) < get(oldest->last)) oldest = &range;
      if (get(range.reads) == 0) break;
    }
    set(oldest->reads, std::uint32_t{0});
    set(oldest->key, key);
    note(*oldest, now);
  }

  /// The mean time between reads of a position, 0 if it is read more often than the time advances; -1 if it is not read
  /// again and again. O(kRanges).
  tables::Time every(std::uint32_t position, tables::Time now) const noexcept {
    tables::Time shortest = -1;
    for (const Range& range : ranges_) {
      const std::uint64_t key = get(range.key);
      if (get(range.reads) < 2 || now - get(range.last) > kForgotten) continue;
      if (position < key >> 32 || position - (key >> 32) >= (key & 0xFFFF'FFFF)) continue;
      shortest = shortest < 0 ? get(range.every) : std::min(shortest, get(range.every));
    }
    return shortest;
  }

 private:
  struct Range {
    std::atomic<std::uint64_t> key{0};    ///< first position and number of positions
    std::atomic<std::uint32_t> reads{0};  ///< 2: two or more
    std::atomic<tables::Time> last{0};
    std::atomic<tables::Time> every{0};
  };
  static constexpr std::size_t kRanges = 32;

  template <class T>
  static T get(const std::atomic<T>& value) noexcept {
    return value.load(std::memory_order_relaxed);
  }
  template <class T>
  static void set(std::atomic<T>& value, T to) noexcept {
    value.store(to, std::memory_order_relaxed);
  }

  static void note(Range& range, tables::Time now) noexcept {
    constexpr tables::Time kWeight = 8;  // of all reads before, to that of the last one
    const tables::Time since = now - get(range.last);
    const std::uint32_t reads = since > kForgotten ? 0 : get(range.reads);
    if (reads == 1) set(range.every, since);
    if (reads > 1) set(range.every, get(range.every) + (since - get(range.every)) / kWeight);
    set(range.last, now);
    set(range.reads, std::min<std::uint32_t>(reads + 1, 2));
  }

  std::array<Range, kRanges> ranges_;
};

}  // namespace symplant::link::image

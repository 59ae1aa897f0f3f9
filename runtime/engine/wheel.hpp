// When units become due: an exact monotone radix wheel, 256-way, with one intrusive entry a unit.
//
// A bucket is chosen by the highest group of eight bits in which a due time differs from `last`, and by the due time's
// digit in that group (a radix heap: Ahuja, Mehlhorn, Orlin, Tarjan, "Faster algorithms for the shortest path problem",
// 1990). As time goes on a bucket is cut into lower ones; a unit moves down at most once a group, so that arming and
// expiry cost O(1) amortised whatever the number of units.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "symplant/engine/unit_state.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::engine {

/// Lies in the flat block: indices only.
class Wheel {
 public:
  static constexpr std::uint32_t kNone = 0xFFFF'FFFF;

  void clear() noexcept;

  /// `due` must not lie before any time that expired() has given.
  void insert(UnitState* units, std::uint32_t unit, tables::Time due) noexcept {
    units[unit].due = due;
    units[unit].flags |= kTimed;
    link(units, unit, bucket_of(due));
    bound_ = std::min(bound_, due);
  }
  void remove(UnitState* units, std::uint32_t unit) noexcept;

  /// The earliest due time up to and including `limit`, or kNever. Nothing before `limit` may be inserted afterwards
  /// that lies before what this gives (or before `limit`, where it gives kNever).
  tables::Time earliest(UnitState* units, tables::Time limit) noexcept;
  /// The earliest due time of all, or kNever; changes nothing. O(units of one bucket).
  tables::Time peek(const UnitState* units) const noexcept;

  /// Takes all units due at `time`, which earliest() has just given, out of the wheel: the first of them, chained by
  /// `next`, their kTimed flags still set.
  std::uint32_t take(tables::Time time) noexcept;
  /// The only unit due at `time`, likewise, or kNone where there are more.
  std::uint32_t sole(const UnitState* units, tables::Time time) const noexcept {
    const std::uint32_t first = heads_[digit_of(time, 0)];
    return units[first].next == kNone ? first : kNone;
  }

 private:
  static constexpr std::uint32_t kBits = 8;
  static constexpr std::uint32_t kTransitions = 1U << kBits;
  static constexpr std::size_t kLevels = 8;
  static constexpr std::uint32_t kWords = kTransitions / 64;  ///< of `occupied_`, a level

  static std::uint32_t digit_of(tables::Time time, std::uint32_t level) noexcept {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(time) >> (kBits * level)) & (kTransitions - 1);
  }
  std::uint32_t bucket_of(tables::Time due) const noexcept {
    const std::uint64_t difference = static_cast<std::uint64_t>(due) ^ static_cast<std::uint64_t>(last_);
    const auto level = static_cast<std::uint32_t>(63 - std::countl_zero(difference | 1)) / kBits;
    return level * kTransitions + digit_of(due, level);
  }
  void link(UnitState* units, std::uint32_t unit, std::uint32_t bucket) noexcept {
    const std::uint32_t head = heads_[bucket];
    units[unit].next = head;
    units[unit].previous = kNone;
    heads_[bucket] = unit;
    if (head != kNone) {
      units[head].previous = unit;
    } else {
      occupy(bucket);
    }
  }
  void occupy(std::uint32_t bucket) noexcept {
    occupied_[bucket / 64] |= std::uint64_t{1} << (bucket % 64);
    words_ |= std::uint32_t{1} << (bucket / 64);
  }
  /// It has no unit any more.
  void vacate(std::uint32_t bucket) noexcept {
    heads_[bucket] = kNone;
    occupied_[bucket / 64] &= ~(std::uint64_t{1} << (bucket % 64));
    if (occupied_[bucket / 64] == 0) words_ &= ~(std::uint32_t{1} << (bucket / 64));
  }
  /// The one that holds the earliest of all.
  std::uint32_t lowest_bucket() const noexcept {
    const auto word = static_cast<std::uint32_t>(std::countr_zero(words_));
    return word * 64 + static_cast<std::uint32_t>(std::countr_zero(occupied_[word]));
  }
  void redistribute(UnitState* units, std::uint32_t bucket) noexcept;
  struct Range {
    tables::Time first;
    tables::Time last;
  };
  /// Of a bucket that is not empty. O(its units).
  Range bucket_range(const UnitState* units, std::uint32_t bucket) const noexcept;

  tables::Time last_;    ///< no entry lies before it
  tables::Time bound_;   ///< nor before this: an idle look costs one compare
  std::uint32_t words_;  ///< bit w: occupied_[w] is not 0
  std::array<std::uint64_t, kLevels * kWords> occupied_;
  std::array<std::uint32_t, kLevels * kTransitions> heads_;
};

}  // namespace symplant::engine

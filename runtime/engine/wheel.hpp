// The due times of units: an exact monotone radix wheel, 256 buckets per level, one intrusive entry per unit.
//
// The bucket of a due time depends on the highest group of eight bits in which it differs from `last`, and on its digit
// in that group (a radix heap: Ahuja, Mehlhorn, Orlin, Tarjan, "Faster algorithms for the shortest path problem",
// 1990). As time advances a bucket is cut into lower ones. A unit moves down at most once per group, so arming and
// expiry cost amortized O(1) for any number of units.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "symplant/engine/unit_state.hpp"
#include "symplant/tables/tables.hpp"
#include "symplant/tables/time.hpp"

namespace symplant::engine {

/// Lies in the flat block: it has indexes and no pointers.
class Wheel {
 public:
  void clear() noexcept;

  /// `due` must not be before any time that earliest() has returned.
  void insert(UnitState* units, std::uint32_t unit, tables::Time due) noexcept {
    units[unit].due = due;
    units[unit].flags |= kTimed;
    if (due != inserted_) {  // units that leave together often arrive together
      inserted_ = due;
      bucket_ = bucket_of(due);
      bound_ = std::min(bound_, due);
    }
    link(units, unit, unit, bucket_);
  }
  void remove(UnitState* units, std::uint32_t unit) noexcept;

  /// The earliest due time up to and including `limit`, or kNever. Afterwards no due time before the returned time may
  /// be inserted (or before `limit`, if it returned kNever).
  tables::Time earliest(UnitState* units, tables::Time limit) noexcept;
  /// The earliest due time of all, or kNever; changes nothing. O(1), or O(units of one bucket) if it has several due
  /// times.
  tables::Time peek(const UnitState* units) const noexcept;

  /// Removes all units that are due at `time`, which earliest() has just returned. Returns the first of them; the
  /// others are chained by `next`. Their kTimed flags stay set.
  std::uint32_t take(tables::Time time) noexcept;
  /// The only unit due at `time`, which earliest() has just returned, or tables::kNone if there are several.
  std::uint32_t sole(const UnitState* units, tables::Time time) const noexcept {
    const std::uint32_t first = heads_[digit_of(time, 0)];
    return units[first].next == tables::kNone ? first : tables::kNone;
  }

 private:
  static constexpr std::uint32_t kBits = 8;
  static constexpr std::uint32_t kTransitions = 1U << kBits;
  static constexpr std::size_t kLevels = 8;
  static constexpr std::uint32_t kWords = kTransitions / 64;  ///< words of `occupied_` per level

  static std::uint32_t digit_of(tables::Time time, std::uint32_t level) noexcept {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(time) >> (kBits * level)) & (kTransitions - 1);
  }
  std::uint32_t bucket_of(tables::Time due) const noexcept {
    const std::uint64_t difference = static_cast<std::uint64_t>(due) ^ static_cast<std::uint64_t>(last_);
    const auto level = static_cast<std::uint32_t>(63 - std::countl_zero(difference | 1)) / kBits;
    return level * kTransitions + digit_of(due, level);
  }
  /// Puts a chain of units of one due time, linked from `first` to `last`, at the front of a bucket.
  void link(UnitState* units, std::uint32_t first, std::uint32_t last, std::uint32_t bucket) noexcept {
    const std::uint32_t head = heads_[bucket];
    units[last].next = head;
    units[first].previous = tables::kNone;
    heads_[bucket] = first;
    if (head != tables::kNone) {
      units[head].previous = last;
      if (units[head].due != units[first].due) mixed_[bucket / 64] |= std::uint64_t{1} << (bucket % 64);
    } else {
      occupy(bucket);
    }
  }
  /// False: all entries of the bucket have one due time.
  bool is_mixed(std::uint32_t bucket) const noexcept { return (mixed_[bucket / 64] >> (bucket % 64) & 1) != 0; }
  void occupy(std::uint32_t bucket) noexcept {
    occupied_[bucket / 64] |= std::uint64_t{1} << (bucket % 64);
    words_ |= std::uint32_t{1} << (bucket / 64);
  }
  /// Marks a bucket as empty.
  void vacate(std::uint32_t bucket) noexcept {
    heads_[bucket] = tables::kNone;
    mixed_[bucket / 64] &= ~(std::uint64_t{1} << (bucket % 64));
    occupied_[bucket / 64] &= ~(std::uint64_t{1} << (bucket % 64));
    if (occupied_[bucket / 64] == 0) words_ &= ~(std::uint32_t{1} << (bucket / 64));
  }
  /// The bucket with the earliest entry; the wheel must not be empty.
  std::uint32_t lowest_bucket() const noexcept {
    const auto word = static_cast<std::uint32_t>(std::countr_zero(words_));
    return word * 64 + static_cast<std::uint32_t>(std::countr_zero(occupied_[word]));
  }
  void redistribute(UnitState* units, std::uint32_t bucket) noexcept;

  tables::Time last_;      ///< no entry is before it
  tables::Time bound_;     ///< no entry is before it: a call with nothing due costs one comparison
  tables::Time inserted_;  ///< due time of the last insert(), or -1 if `bucket_` may no longer be its bucket
  std::uint32_t bucket_;
  std::uint32_t words_;  ///< bit w: occupied_[w] is not 0
  std::array<std::uint64_t, kLevels * kWords> occupied_;
  std::array<std::uint64_t, kLevels * kWords> mixed_;  ///< the buckets whose entries may differ in their due times
  std::array<std::uint32_t, kLevels * kTransitions> heads_;
};

}  // namespace symplant::engine

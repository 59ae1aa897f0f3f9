// The radix wheel of due times.
#include "symplant/engine/wheel.hpp"

#include <algorithm>

namespace symplant::engine {

void Wheel::clear() noexcept {
  last_ = 0;
  bound_ = tables::kNever;
  inserted_ = -1;
  bucket_ = 0;
  words_ = 0;
  occupied_.fill(0);
  heads_.fill(tables::kNone);
}

void Wheel::remove(UnitState* units, std::uint32_t unit) noexcept {
  UnitState& state = units[unit];
  if (state.next != tables::kNone) units[state.next].previous = state.previous;
  if (state.previous != tables::kNone) {
    units[state.previous].next = state.next;
  } else {
    const std::uint32_t bucket = bucket_of(state.due);  // still its bucket after every cut
    heads_[bucket] = state.next;
    if (state.next == tables::kNone) vacate(bucket);
  }
  state.flags &= static_cast<std::uint16_t>(~kTimed);
}

Wheel::Range Wheel::bucket_range(const UnitState* units, std::uint32_t bucket) const noexcept {
  std::uint32_t unit = heads_[bucket];
  tables::Time due = units[unit].due;
  Range range{due, due};
  while ((unit = units[unit].next) != tables::kNone) {
    if (units[unit].due == due) continue;
    due = units[unit].due;
    range.first = std::min(range.first, due);
    range.last = std::max(range.last, due);
  }
  return range;
}

/// Neighbors of one due time move together.
void Wheel::redistribute(UnitState* units, std::uint32_t bucket) noexcept {
  std::uint32_t first = heads_[bucket];
  vacate(bucket);
  while (first != tables::kNone) {
    const tables::Time due = units[first].due;
    std::uint32_t last = first;
    std::uint32_t next = units[last].next;
    while (next != tables::kNone && units[next].due == due) {
      last = next;
      next = units[last].next;
    }
    link(units, first, last, bucket_of(due));
    first = next;
  }
}

tables::Time Wheel::earliest(UnitState* units, tables::Time limit) noexcept {
  if (limit < bound_) return tables::kNever;
  inserted_ = -1;  // what follows may change its bucket
  while (words_ != 0) {
    const std::uint32_t bucket = lowest_bucket();
    if (bucket < kTransitions) {
      bound_ = (last_ & ~tables::Time{kTransitions - 1}) | bucket;
      return bound_ <= limit ? bound_ : tables::kNever;
    }
    // The bucket's first time: the higher groups of last_, the bucket's digit, then zeros.
    const std::uint32_t shift = bucket / kTransitions * kBits;
    const std::uint64_t above = shift + kBits < 64 ? ~std::uint64_t{0} << (shift + kBits) : 0;
    const std::uint64_t digit = bucket % kTransitions;
    const auto base = static_cast<tables::Time>((static_cast<std::uint64_t>(last_) & above) | (digit << shift));
    if (base > limit) {
      bound_ = base;
      return tables::kNever;
    }
    // Cut the bucket even if its first entry is not due yet: time has reached the bucket, and without the cut every
    // later call would walk it.
    const auto [first, last] = bucket_range(units, bucket);
    last_ = first <= limit ? first : base;
    if (first == last && first <= limit) {  // all at one time: it becomes the bucket of that time unchanged
      const std::uint32_t now = digit_of(last_, 0);
      heads_[now] = heads_[bucket];
      vacate(bucket);
      occupy(now);
    } else {
      redistribute(units, bucket);
    }
  }
  bound_ = tables::kNever;
  return tables::kNever;
}

tables::Time Wheel::peek(const UnitState* units) const noexcept {
  if (words_ == 0) return tables::kNever;
  const std::uint32_t bucket = lowest_bucket();
  return bucket < kTransitions ? (last_ & ~tables::Time{kTransitions - 1}) | bucket : bucket_range(units, bucket).first;
}

std::uint32_t Wheel::take(tables::Time time) noexcept {
  const std::uint32_t bucket = digit_of(time, 0);
  const std::uint32_t first = heads_[bucket];
  vacate(bucket);
  return first;
}

}  // namespace symplant::engine

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
  mixed_.fill(0);
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
    if (!is_mixed(bucket)) {  // it becomes the bucket of its one due time unchanged
      const tables::Time due = units[heads_[bucket]].due;
      if (due > limit) {
        bound_ = due;
        return tables::kNever;
      }
      last_ = due;
      const std::uint32_t now = digit_of(due, 0);
      heads_[now] = heads_[bucket];
      vacate(bucket);
      occupy(now);
      continue;
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
    last_ = base;
    redistribute(units, bucket);
  }
  bound_ = tables::kNever;
  return tables::kNever;
}

tables::Time Wheel::peek(const UnitState* units) const noexcept {
  if (words_ == 0) return tables::kNever;
  const std::uint32_t bucket = lowest_bucket();
  std::uint32_t unit = heads_[bucket];
  tables::Time first = units[unit].due;
  if (!is_mixed(bucket)) return first;
  while ((unit = units[unit].next) != tables::kNone) first = std::min(first, units[unit].due);
  return first;
}

std::uint32_t Wheel::take(tables::Time time) noexcept {
  const std::uint32_t bucket = digit_of(time, 0);
  const std::uint32_t first = heads_[bucket];
  vacate(bucket);
  return first;
}

}  // namespace symplant::engine

// The radix wheel.
#include "symplant/core/wheel.hpp"

#include <algorithm>
#include <bit>

namespace symplant::core {

void Wheel::clear() noexcept {
  last_ = 0;
  bound_ = kNever;
  levels_ = 0;
  occupied_.fill(0);
  heads_.fill(kNone);
}

std::uint32_t Wheel::bucket_of(Time due) const noexcept {
  const auto value = static_cast<std::uint64_t>(due);
  const std::uint64_t difference = value ^ static_cast<std::uint64_t>(last_);
  const auto level = static_cast<std::uint32_t>(63 - std::countl_zero(difference | 1)) / 6;
  return level * 64 + static_cast<std::uint32_t>((value >> (6 * level)) & 63);
}

void Wheel::link(UnitState* units, std::uint32_t unit) noexcept {
  const std::uint32_t bucket = bucket_of(units[unit].due);
  const std::uint32_t head = heads_[bucket];
  units[unit].next = head;
  units[unit].previous = kNone;
  if (head != kNone) units[head].previous = unit;
  heads_[bucket] = unit;
  occupied_[bucket / 64] |= std::uint64_t{1} << (bucket % 64);
  levels_ |= std::uint64_t{1} << (bucket / 64);
}

void Wheel::insert(UnitState* units, std::uint32_t unit, Time due) noexcept {
  units[unit].due = due;
  units[unit].flags |= kTimed;
  link(units, unit);
  bound_ = std::min(bound_, due);
}

void Wheel::remove(UnitState* units, std::uint32_t unit) noexcept {
  UnitState& state = units[unit];
  if (state.next != kNone) units[state.next].previous = state.previous;
  if (state.previous != kNone) {
    units[state.previous].next = state.next;
  } else {
    const std::uint32_t bucket = bucket_of(state.due);  // where it was put, whatever has been cut since
    heads_[bucket] = state.next;
    if (state.next == kNone) {
      occupied_[bucket / 64] &= ~(std::uint64_t{1} << (bucket % 64));
      if (occupied_[bucket / 64] == 0) levels_ &= ~(std::uint64_t{1} << (bucket / 64));
    }
  }
  state.flags &= static_cast<std::uint8_t>(~kTimed);
}

std::uint32_t Wheel::lowest_level() const noexcept { return static_cast<std::uint32_t>(std::countr_zero(levels_)); }

std::uint32_t Wheel::lowest_digit(std::uint32_t level) const noexcept {
  return static_cast<std::uint32_t>(std::countr_zero(occupied_[level]));
}

Time Wheel::bucket_minimum(const UnitState* units, std::uint32_t bucket) const noexcept {
  Time minimum = kNever;
  for (std::uint32_t unit = heads_[bucket]; unit != kNone; unit = units[unit].next) {
    minimum = std::min(minimum, units[unit].due);
  }
  return minimum;
}

void Wheel::redistribute(UnitState* units, std::uint32_t level, std::uint32_t digit) noexcept {
  const std::uint32_t bucket = level * 64 + digit;
  std::uint32_t unit = heads_[bucket];
  heads_[bucket] = kNone;
  occupied_[level] &= ~(std::uint64_t{1} << digit);
  if (occupied_[level] == 0) levels_ &= ~(std::uint64_t{1} << level);
  while (unit != kNone) {
    const std::uint32_t next = units[unit].next;
    link(units, unit);
    unit = next;
  }
}

Time Wheel::earliest(UnitState* units, Time limit) noexcept {
  if (limit < bound_) return kNever;
  while (levels_ != 0) {
    const std::uint32_t level = lowest_level();
    const std::uint32_t digit = lowest_digit(level);
    if (level == 0) {
      bound_ = (last_ & ~Time{63}) | digit;
      return bound_ <= limit ? bound_ : kNever;
    }
    // The bucket's first time: the groups above from last_, its digit, zeros.
    const std::uint32_t shift = 6 * level;
    const std::uint64_t above = shift + 6 < 64 ? ~std::uint64_t{0} << (shift + 6) : 0;
    const auto base = static_cast<Time>((static_cast<std::uint64_t>(last_) & above) | (std::uint64_t{digit} << shift));
    if (base > limit) {
      bound_ = base;
      return kNever;
    }
    // Cut the bucket whether or not its first entry is due yet: time has reached it, and so it is never walked in vain
    // twice.
    const Time minimum = bucket_minimum(units, level * 64 + digit);
    last_ = minimum <= limit ? minimum : base;
    redistribute(units, level, digit);
  }
  bound_ = kNever;
  return kNever;
}

Time Wheel::peek(const UnitState* units) const noexcept {
  if (levels_ == 0) return kNever;
  const std::uint32_t level = lowest_level();
  const std::uint32_t digit = lowest_digit(level);
  if (level == 0) return (last_ & ~Time{63}) | digit;
  return bucket_minimum(units, level * 64 + digit);
}

std::uint32_t Wheel::take(Time time) noexcept {
  const auto digit = static_cast<std::uint32_t>(time & 63);
  const std::uint32_t first = heads_[digit];
  heads_[digit] = kNone;
  occupied_[0] &= ~(std::uint64_t{1} << digit);
  if (occupied_[0] == 0) levels_ &= ~std::uint64_t{1};
  return first;
}

}  // namespace symplant::core

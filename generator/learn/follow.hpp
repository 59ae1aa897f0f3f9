// How the changes of an event follow those of an operation.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "learn/timeline.hpp"

namespace symplant::learn {

/// Changes of a symbol in one direction.
struct Edges {
  const std::vector<Time>& times;
  const Track& track;
  bool on;  ///< whether they are those to on

  Edges(const Track& of, bool to_on) : times(to_on ? of.rises : of.falls), track(of), on(to_on) {}
};

/// After each change of an operation: whether the event changes, and how long after it.
struct Follows {
  std::size_t changes = 0;  ///< of the operation, at which the event did not have its value already
  std::size_t hits = 0;     ///< followed by a change of the event within `least` and `most`
  std::size_t effects = 0;  ///< changes of the event, without those before which the recording is too short
  Time median = 0;          ///< of the delays of the hits
  Time least = 0;
  Time most = 0;
  std::size_t central = 0;  ///< the closest delays: 95 % of them, but never all
  double deviation = 0;     ///< the standard deviation of these, in s

  Time spread() const { return most - least; }
};

inline constexpr std::size_t kLeastChanges = 5;

/// 95 of 100, rounded up.
constexpr std::size_t hits_needed(std::size_t changes) { return (changes * 95 + 99) / 100; }

/// The widest spread of delays between `least` and `most` that counts as the same time: a quarter of their middle. Each
/// time is exact to a resolution, so that two more are allowed.
constexpr Time spread_allowed(Time least, Time most, Time resolution) { return (least + most) / 8 + 2 * resolution; }

/// Compares the changes of an operation with those of an event in time. O(changes * log(changes)).
Follows follow(const Edges& operation, const Edges& event, const Timeline& timeline);

/// The closest `count` of sorted delays: the index of the first one.
template <typename Number>
std::size_t closest(std::span<const Number> delays, std::size_t count) {
  std::size_t best = 0;
  for (std::size_t first = 1; first + count <= delays.size(); ++first) {
    if (delays[first + count - 1] - delays[first] < delays[best + count - 1] - delays[best]) best = first;
  }
  return best;
}

/// The standard deviation of sorted delays, in their unit.
template <typename Number>
double deviation_of(std::span<const Number> delays) {
  double sum = 0;
  double squares = 0;
  for (const Number delay : delays) {
    const double from_first = static_cast<double>(delay - delays.front());
    sum += from_first;
    squares += from_first * from_first;
  }
  const double n = static_cast<double>(delays.size());
  return std::sqrt(std::max(0.0, (squares - sum * sum / n) / n));
}

}  // namespace symplant::learn

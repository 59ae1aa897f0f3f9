// Compares the operations that may cause the changes of an event.
#pragma once

#include <vector>

#include "learn/candidates.hpp"
#include "learn/follow.hpp"

namespace symplant::learn {

/// A change of an operation, and how the changes of an event follow it.
struct Cause {
  EdgeOf edge{};
  Follows follows{};
  double deviation = 0;       ///< of the central delays, in s, and not below what the resolution allows
  double cost = 0;            ///< the logarithm of how improbable the times of the event are if this is its cause
  bool same_reading = false;  ///< both always change in one reading: the PLC answers the event

  /// How much more improbable than by another cause the changes are that both explain.
  double excess_over(const Cause& other) const;
};

/// How much the costs of causes must differ for one to be excluded: it is 20 times less probable.
inline constexpr double kClearly = 3;

/// The causes of the changes of an event in one direction, the most probable first, those included that are no pair for
/// other reasons. O(candidates * changes * log(changes)).
std::vector<Cause> causes_of(const Edges& event, const std::vector<EdgeOf>& candidates, const Timeline& timeline);

/// Whether the event changes in the same time after each change of the operation.
bool is_constant(const Cause& cause, const Timeline& timeline);
/// Whether it also follows it, so that the PLC does not answer the event.
bool is_followed(const Cause& cause, const Timeline& timeline);
/// Whether the event does not change otherwise.
bool is_only_cause(const Cause& cause);

}  // namespace symplant::learn

// How long a move may take by the model.
#pragma once

#include "model/plant_model.hpp"
#include "observe/observer.hpp"

namespace symplant::watch {

using model::kNone;
using observe::kUnknown;
using tables::Time;

/// A time that the model bounds.
struct Range {
  Time least = 0;
  Time most = 0;
};

/// What the model allows for a move: from its cause to leaving, and from leaving to arriving.
struct Limits {
  bool known = false;  ///< false: a formula gives a time, or the model has no such move
  Range after;
  Range takes;

  Range total() const { return {after.least + takes.least, after.most + takes.most}; }
};

/// Of a normal distribution, four standard deviations to both sides count. `move.transition` or `move.spring_return`,
/// with `from` and `to`, say which move it is. O(transitions) for a spring's return, else O(1).
Limits limits_of(const model::Unit& unit, const observe::Move& move);

/// The longest time that any move of the unit may take; kUnknown if a formula gives one, or if it has none.
/// O(transitions).
Time longest_move(const model::Unit& unit);

/// What is allowed besides the limits.
struct Margin {
  double share = 0.2;   ///< of the longest time
  Time resolution = 0;  ///< what times are exact to

  /// At least two resolutions.
  Time of(Time most) const;
  /// How long after its cause a move is missing: three times the longest time, at least that and the margin.
  Time missing_after(Time most) const;
};

}  // namespace symplant::watch

// Finds what two groups of durations have to do with.
#pragma once

#include <optional>
#include <vector>

#include "learn/durations.hpp"
#include "learn/input.hpp"
#include "learn/learned.hpp"
#include "model/layout.hpp"

namespace symplant::learn {

/// What may explain groups of durations, by recording: the states of devices, and the parts that arrived last.
class Explainer {
 public:
  /// All must outlive it. O(changes of parts).
  Explainer(const model::PlantModel& plant, const std::vector<Input>& inputs, const Moves& moves);

  /// The thing whose states, when the moves of a time of `unit` were caused, go with the two groups: for at least 90 %
  /// of the moves of each group, and so that less than one in 100 such plants would show it by chance. Nothing if there
  /// are not two groups. O(changes of all devices + devices * samples).
  std::optional<Explanation> explain(std::uint32_t unit, const LearnedTime& time) const;

 private:
  /// The parts that arrived at one location of a recording: by time, the index of the kind in `kinds`.
  struct Arrivals {
    std::string location;
    std::vector<std::string> kinds;
    std::vector<std::vector<StateChange>> by_input;
  };

  const model::PlantModel& plant_;
  const Moves& moves_;
  const model::Layout layout_;
  std::vector<Arrivals> arrivals_;
};

}  // namespace symplant::learn

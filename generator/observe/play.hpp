// Lets an observer follow a recording.
#pragma once

#include <functional>
#include <vector>

#include "model/plant_model.hpp"
#include "observe/matched.hpp"
#include "observe/observer.hpp"
#include "recording/recording.hpp"

namespace symplant::observe {

/// Feeds a recording to an observer, time by time, and passes each step on. A gap makes the observer forget.
/// O(changes).
void play(const recording::Recording& recording, const Matched& matched, Observer& observer,
          const std::function<void(Time, const Step&)>& step);

/// All moves that the recording shows, in the order of their ends. O(changes).
std::vector<Move> moves_of(const model::PlantModel& plant, const recording::Recording& recording,
                           const Matched& matched);

}  // namespace symplant::observe

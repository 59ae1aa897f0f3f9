// The movements that a recording shows, and how accurately a run repeats each of them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "observe/observer.hpp"
#include "recording/recording.hpp"

namespace symplant::study {

using tables::Time;

/// A movement of the recording: of a numeric symbol from rest to rest, or of a device from its cause to its arrival.
struct Movement {
  std::string name;     ///< of the symbol; of a device with its states, `L_P_CLAMP OPEN -> CLOSED`
  Time begin = 0;       ///< when its command changes
  Time end = 0;         ///< when the value comes to rest, or the device arrives
  double accuracy = 0;  ///< 0 to 1

  Time duration() const { return end - begin; }
};

/// A numeric symbol in the recording and in the run.
struct Curve {
  const recording::Series* recorded = nullptr;
  const recording::Series* actual = nullptr;  ///< null: it never changes in the run
  std::vector<Time> commands = {};            ///< when operations change that it depends on, ascending
  double period = 0;                          ///< the distance after which the number begins again; 0: never
  bool whole = true;                          ///< its numbers are integers: a change by 1 may be noise
  double noise = 0;                           ///< its standard deviation in the model
};

/// What is known of the recording.
struct Recorded {
  Time end = 0;
  Time resolution = 0;
  std::span<const recording::Gap> gaps = {};
};

/// The share of a moved distance that a run gets right: 1 - mean difference / distance, at least 0.
double accuracy_of(double mean_difference, double distance);

/// How long a number must stay where it is to be at rest.
Time rest_time(Time resolution);

/// The movements of a numeric symbol (docs/accuracy.md). O(changes + length / resolution).
std::vector<Movement> movements_of(const Curve& curve, const Recorded& of);

/// The movements of devices: each move of the recording with a known cause and a known arrival, compared with the move
/// of the run to the same state. Those whose cause is not after `begin` are left out, as it may be older, and those
/// that the run does not have but may have soon after the end. A move that the run does not have has the accuracy 0.
/// O(moves * log(moves)).
std::vector<Movement> movements_of(const model::PlantModel& plant, const std::vector<observe::Move>& recorded,
                                   const std::vector<observe::Move>& actual, Time begin, const Recorded& of);

}  // namespace symplant::study

// Compares the times that were learned of a plant with those that it really has.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "learn/learned.hpp"
#include "model/plant_model.hpp"

namespace symplant::property {

/// The times of one kind: constant ones, or random ones.
struct Recovered {
  long times = 0;    ///< learned of enough moves
  long right = 0;    ///< a constant within one resolution; a range within the true one and a resolution on both sides
  long wide = 0;     ///< of right ranges: with at least 80 % of the true width
  long of_kind = 0;  ///< a constant is proposed as a constant, a range as a range
  long outside = 0;  ///< of the others: a time is proposed that the device cannot have

  Recovered& operator+=(const Recovered& other);
};

struct RecoveredTimes {
  Recovered constant;
  Recovered random;
  long few = 0;  ///< transitions with fewer moves

  RecoveredTimes& operator+=(const RecoveredTimes& other);
};

/// Judges what was learned of at least `least` moves. Transitions that share their states and operation have one entry
/// in plant.json: they count only if their true times are equal. Adds a line to `misses` for each time that is not
/// right.
RecoveredTimes recovered_times(const model::PlantModel& real, const learn::Learned& learned, std::size_t least,
                               std::vector<std::string>& misses);

}  // namespace symplant::property

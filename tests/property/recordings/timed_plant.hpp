// Random plants whose true times differ from those that their model has.
#pragma once

#include <cstdint>

#include "model/plant_model.hpp"
#include "property/dice.hpp"

namespace symplant::property {

/// One plant as its description has it, and as it really is.
struct TimedPlant {
  model::PlantModel described;  ///< every time is 1 s, or 0
  model::PlantModel real;
  int refused = 0;  ///< plants drawn before that have no device to command
};

struct TimedOptions {
  bool random_times = true;  ///< half of the times are uniform, +-10 %; else all are constant
  bool exact_times = false;  ///< no two constant times of a unit are equal, to the nanosecond
  std::size_t most_units = 30;
};

/// The same plant for the same seed and options, everywhere.
TimedPlant timed_plant(std::uint64_t seed, const TimedOptions& options);

/// Constant times are from 0.3 s to 6 s, random ones from 2 s to 8 s on average: the width of their range is at least
/// 8 intervals of 50 ms.
description::Duration random_true_time(Dice& dice, const TimedOptions& options);

/// The longest time from a cause to the arrival in a unit.
tables::Time longest_move(const model::Unit& unit);

}  // namespace symplant::property

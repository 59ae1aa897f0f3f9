// What times a model is to have, from durations of a real plant.
#pragma once

#include <span>

#include "learn/learned.hpp"

namespace symplant::learn {

/// The unit in which times of a resolution are given: the power of ten that is at most the resolution. 1 ns at least.
Time digit_of(Time resolution);

/// A time rounded to a multiple of `digit`.
Time rounded(Time time, Time digit);

/// `durations` are sorted.
Statistics statistics_of(std::span<const Time> durations, Time resolution);

/// A constant, the mean, if the durations differ by at most 2 resolutions or 1 %; else from the least to the largest.
/// `durations` are sorted; 0 without durations.
description::Duration proposal_of(std::span<const Time> durations, Time resolution);

/// How long a command may stay on after arrival: the longest time, and as a margin 20 % of it, at least 2 resolutions
/// and 100 ms. `durations` are sorted, and at least one.
description::Duration overrun_of(std::span<const Time> durations, Time resolution);

}  // namespace symplant::learn

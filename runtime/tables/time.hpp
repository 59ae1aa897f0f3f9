// Plant time: signed 64-bit nanoseconds.
#pragma once

#include <cstdint>
#include <limits>

namespace symplant::tables {

/// Nanoseconds of plant time since the plant's reset, or a duration in nanoseconds.
using Time = std::int64_t;

inline constexpr Time kNanosecond = 1;
inline constexpr Time kMicrosecond = 1'000;
inline constexpr Time kMillisecond = 1'000'000;
inline constexpr Time kSecond = 1'000'000'000;

/// Later than every due time.
inline constexpr Time kNever = std::numeric_limits<Time>::max();

}  // namespace symplant::tables

// A pulse that the other side of a link has missed, in the 64 bits of a finding's value.
#pragma once

#include <algorithm>
#include <cstdint>

#include "symplant/tables/time.hpp"

namespace symplant::tables {

/// A bit that came and went between two looks at it.
struct MissedPulse {
  bool on = false;  ///< the value that was missed, as on the wire
  Time length = 0;  ///< how long the bit had that value; 0: less than a cycle
  Time every = 0;   ///< from one look to the next

  bool operator==(const MissedPulse&) const = default;
};

/// Bit 63 is `on`, bits 32 to 62 are the length and 0 to 31 the time between looks, both in us. Longer times are cut to
/// 35 and 71 minutes.
constexpr std::uint64_t pack(const MissedPulse& pulse) {
  constexpr Time kLongest = 0x7FFF'FFFF;
  constexpr Time kRarest = 0xFFFF'FFFF;
  const auto length = static_cast<std::uint64_t>(std::clamp<Time>(pulse.length / kMicrosecond, 0, kLongest));
  const auto every = static_cast<std::uint64_t>(std::clamp<Time>(pulse.every / kMicrosecond, 0, kRarest));
  return std::uint64_t{pulse.on} << 63 | length << 32 | every;
}

constexpr MissedPulse unpack_missed_pulse(std::uint64_t value) {
  return {(value >> 63) != 0, static_cast<Time>(value >> 32 & 0x7FFF'FFFF) * kMicrosecond,
          static_cast<Time>(value & 0xFFFF'FFFF) * kMicrosecond};
}

}  // namespace symplant::tables

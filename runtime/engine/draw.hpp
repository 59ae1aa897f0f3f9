// Random numbers and times as docs/model.md specifies them, equal on every machine and with every library.
#pragma once

#include <cstdint>

#include "symplant/tables/tables.hpp"

namespace symplant::engine {

/// The SplitMix64 state (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014) at which draw `k`
/// of a unit's stream `stream` begins. `unit` is fnv1a64 of the unit's name.
constexpr std::uint64_t draw_start(std::uint64_t seed, std::uint64_t unit, std::uint16_t stream,
                                   std::uint32_t k) noexcept {
  return seed ^ unit ^ (std::uint64_t{stream} << 32) ^ k;
}

/// SplitMix64's next output.
constexpr std::uint64_t split_mix(std::uint64_t& state) noexcept {
  state += 0x9E37'79B9'7F4A'7C15;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xBF58'476D'1CE4'E5B9;
  z = (z ^ (z >> 27)) * 0x94D0'49BB'1331'11EB;
  return z ^ (z >> 31);
}

/// The sum of twelve uniform numbers, less its mean, times 2^32: nearly normal, with variance 1.
constexpr std::int64_t normal_sum(std::uint64_t& state) noexcept {
  std::int64_t sum = -(std::int64_t{6} << 32);
  for (int i = 0; i < 12; ++i) sum += static_cast<std::int64_t>(split_mix(state) >> 32);
  return sum;
}

/// A time of the given distribution, from a generator that starts at `state`: ns, >= 0.
tables::Time random_time(const tables::RandomTime& time, std::uint64_t state) noexcept;

}  // namespace symplant::engine

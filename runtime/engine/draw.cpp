// Draws random times.
#include "symplant/engine/draw.hpp"

#include "symplant/engine/wide.hpp"

namespace symplant::engine {
namespace {

/// Uniform on [first, last].
tables::Time uniform(tables::Time first, tables::Time last, std::uint64_t random) noexcept {
  const Wide width = static_cast<Wide>(static_cast<std::uint64_t>(last - first)) + 1;
  return first + static_cast<tables::Time>((static_cast<Wide>(random) * width) >> 64);
}

tables::Time normal(tables::Time mean, tables::Time sigma, std::uint64_t& state) noexcept {
  const SignedWide scaled = static_cast<SignedWide>(sigma) * normal_sum(state);
  const SignedWide time = static_cast<SignedWide>(mean) + (scaled >> 32);  // rounds down, also below zero
  if (time < 0) return 0;
  return time > tables::kNever ? tables::kNever : static_cast<tables::Time>(time);
}

}  // namespace

tables::Time random_time(const tables::RandomTime& time, std::uint64_t state) noexcept {
  return time.kind == tables::RandomTime::Kind::uniform ? uniform(time.a, time.b, split_mix(state))
                                                        : normal(time.a, time.b, state);
}

}  // namespace symplant::engine

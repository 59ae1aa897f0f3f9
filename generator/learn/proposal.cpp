// Rounds durations, and makes one time of many.
#include "learn/proposal.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace symplant::learn {
namespace {

constexpr Time kConstantResolutions = 2;
constexpr Time kConstantShare = 100;  ///< of a duration: 1 %
constexpr Time kMeanShare = 10;       ///< of the spread of exact times: to what their mean is given
constexpr Time kOverrunShare = 5;     ///< of a duration: 20 %
constexpr Time kOverrunResolutions = 2;
constexpr Time kLeastOverrunMargin = 100 * tables::kMillisecond;

/// No sum of durations overflows: a recording ends at a quarter of the largest time.
Time mean_of(std::span<const Time> durations) {
  const Time least = durations.front();
  const auto above = std::accumulate(durations.begin(), durations.end(), 0.0,
                                     [&](double sum, Time time) { return sum + static_cast<double>(time - least); });
  return least + std::llround(above / static_cast<double>(durations.size()));
}

Time rounded_up(Time time, Time digit) { return (time + digit - 1) / digit * digit; }

}  // namespace

Time digit_of(Time resolution) {
  Time digit = 1;
  while (digit <= resolution / 10) digit *= 10;
  return digit;
}

Time rounded(Time time, Time digit) { return (time + digit / 2) / digit * digit; }

Statistics statistics_of(std::span<const Time> durations, Time resolution) {
  if (durations.empty()) return {};
  const Time digit = digit_of(resolution);
  const std::size_t count = durations.size();
  const std::size_t upper = count / 2;
  const Time median = count % 2 == 1 ? durations[upper] : std::midpoint(durations[upper - 1], durations[upper]);
  const std::size_t p95 = (count * 95 + 99) / 100 - 1;  // the smallest that 95 % do not exceed
  return {count, rounded(durations.front(), digit), rounded(median, digit), rounded(durations[p95], digit),
          rounded(durations.back(), digit)};
}

description::Duration proposal_of(std::span<const Time> durations, Time resolution) {
  if (durations.empty()) return {};
  const Time least = durations.front();
  const Time most = durations.back();
  const Time spread = most - least;
  if (spread <= std::max(kConstantResolutions * resolution, most / kConstantShare)) {
    const Time digit = digit_of(resolution > 0 ? resolution : spread / kMeanShare);
    return description::Duration::fixed(rounded(mean_of(durations), digit));
  }
  const Time digit = digit_of(resolution);
  // Rounded to the inside, so that no time is proposed that was not seen.
  const Time min = rounded_up(least, digit);
  const Time max = most / digit * digit;
  return {description::Duration::Kind::uniform, min, max};
}

description::Duration overrun_of(std::span<const Time> durations, Time resolution) {
  const Time most = durations.back();
  const Time margin = std::max({most / kOverrunShare, kOverrunResolutions * resolution, kLeastOverrunMargin});
  return description::Duration::fixed(rounded_up(most + margin, digit_of(resolution)));
}

}  // namespace symplant::learn

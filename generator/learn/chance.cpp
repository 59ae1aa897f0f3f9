// Counts the hits of shifted changes.
#include "learn/chance.hpp"

#include <algorithm>

#include "symplant/engine/draw.hpp"

namespace symplant::learn {
namespace {

constexpr std::size_t kMostExamined = 64;
constexpr Time kDistances = 2;

/// The changes of the operation that count, evenly taken from all.
std::vector<Time> examined(const Edges& operation, const Edges& event) {
  std::vector<Time> times;
  std::size_t value = 0;
  const std::vector<Track::Value>& values = event.track.values;
  for (const Time time : operation.times) {
    while (value < values.size() && values[value].time < time) ++value;
    if ((value > 0 && values[value - 1].on) != event.on) times.push_back(time);
  }
  if (times.size() <= kMostExamined) return times;
  std::vector<Time> some(kMostExamined);
  for (std::size_t i = 0; i < some.size(); ++i) some[i] = times[i * times.size() / some.size()];
  return some;
}

bool hits(const std::vector<Time>& effects, Time time, const Follows& follows) {
  const auto effect = std::lower_bound(effects.begin(), effects.end(), time);
  return effect != effects.end() && *effect - time >= follows.least && *effect - time <= follows.most;
}

/// How far changes are shifted: over some of their distances, so that the event is as busy there.
Time longest_shift(const std::vector<Time>& times) {
  std::vector<Time> distances;
  for (std::size_t i = 1; i < times.size(); ++i) distances.push_back(times[i] - times[i - 1]);
  if (distances.empty()) return kLongestDelay;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return std::min(kLongestDelay, kDistances * *middle);
}

/// A time up to `most` from another, and in the same stretch.
Time shifted(Time time, Time most, const Stretch& stretch, std::uint64_t& state) {
  const Time begin = std::max(stretch.begin, time - most);
  const Time length = std::min(stretch.end, time + most) - begin;
  return begin + static_cast<Time>(engine::split_mix(state) % static_cast<std::uint64_t>(length + 1));
}

}  // namespace

Chance chance_of(const Edges& operation, const Edges& event, const Follows& follows, const Timeline& timeline,
                 std::uint64_t seed, std::uint64_t pair) {
  const std::vector<Time> times = examined(operation, event);
  Chance chance;
  chance.changes = times.size();
  for (const Time time : times) chance.hits += hits(event.times, time, follows) ? 1U : 0U;
  const Time most = longest_shift(operation.times);
  std::uint64_t state = engine::draw_start(seed, pair, 0, 0);
  std::size_t sum = 0;
  for (std::size_t trial = 0; trial < kTrials; ++trial) {
    std::size_t count = 0;
    for (const Time time : times) {
      count += hits(event.times, shifted(time, most, timeline.stretch_of(time), state), follows) ? 1U : 0U;
    }
    sum += count;
    chance.most = std::max(chance.most, count);
  }
  chance.mean = static_cast<double>(sum) / kTrials;
  return chance;
}

}  // namespace symplant::learn

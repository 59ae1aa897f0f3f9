// Weighs causes by how constant their delays are.
#include "learn/causes.hpp"

#include <algorithm>
#include <cmath>

namespace symplant::learn {
namespace {

constexpr double kLeastDeviation = 1e-3;  // s

double deviation_of(const Follows& follows, Time resolution) {
  const double least = std::max(kLeastDeviation, static_cast<double>(resolution) / tables::kSecond / std::sqrt(12.0));
  return std::hypot(follows.deviation, least);
}

/// A cause that is not the next one before the event has the variation of all that happens between them in its delays.
/// The times of the event are normal around the delay of their cause; a change without it may be at any time within the
/// longest delay.
double cost_of(const Cause& cause, std::size_t effects) {
  const double explained = static_cast<double>(cause.follows.central);
  const double others = static_cast<double>(effects) - explained;
  return explained * std::log(cause.deviation) +
         others * std::log(static_cast<double>(kLongestDelay) / tables::kSecond);
}

}  // namespace

double Cause::excess_over(const Cause& other) const {
  return static_cast<double>(std::min(follows.central, other.follows.central)) * std::log(deviation / other.deviation);
}

std::vector<Cause> causes_of(const Edges& event, const std::vector<EdgeOf>& candidates, const Timeline& timeline) {
  std::vector<Cause> causes;
  for (const EdgeOf& edge : candidates) {
    Cause cause{edge, follow(Edges(timeline.tracks[edge.symbol], edge.on), event, timeline), 0, 0, false};
    if (cause.follows.changes < kLeastChanges) continue;
    cause.deviation = deviation_of(cause.follows, timeline.resolution);
    cause.cost = cost_of(cause, event.times.size());
    cause.same_reading = cause.follows.most == 0 || cause.follows.most < timeline.resolution;
    causes.push_back(cause);
  }
  std::stable_sort(causes.begin(), causes.end(), [](const Cause& a, const Cause& b) { return a.cost < b.cost; });
  return causes;
}

bool is_constant(const Cause& cause, const Timeline& timeline) {
  const Follows& follows = cause.follows;
  const Track& track = timeline.tracks[cause.edge.symbol];
  const std::size_t all = (cause.edge.on ? track.rises : track.falls).size();
  return follows.changes >= kLeastChanges && 2 * follows.changes >= all &&
         follows.hits >= hits_needed(follows.changes) &&
         follows.spread() <= follows.median / 4 + 2 * timeline.resolution;
}

bool is_followed(const Cause& cause, const Timeline& timeline) {
  return !cause.same_reading && is_constant(cause, timeline);
}

bool is_only_cause(const Cause& cause) { return cause.follows.hits >= hits_needed(cause.follows.effects); }

}  // namespace symplant::learn

// How long moves took on average, by device: what `symplant watch` compares with to notice wear.
#include "learn/baseline.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "learn/clusters.hpp"

namespace symplant::learn {
namespace {

struct MeasuredSpan {
  const char* name;
  bool (*shows)(const TimedMove&);
  Time (*of)(const TimedMove&);
};

constexpr MeasuredSpan kSpans[] = {
    {"after", [](const TimedMove& move) { return move.shows_leaving(); },
     [](const TimedMove& move) { return move.left - move.cause; }},
    {"takes", [](const TimedMove& move) { return move.shows_leaving() && move.shows_arrival(); },
     [](const TimedMove& move) { return move.arrived - move.left; }},
    {"total", [](const TimedMove& move) { return !move.shows_leaving() && move.shows_arrival(); },
     [](const TimedMove& move) { return move.arrived - move.cause; }},
};

std::optional<Baseline> baseline_of(const TransitionMoves& moves, const MeasuredSpan& span,
                                    const std::vector<Source>& sources) {
  std::vector<Sample> samples;
  Time resolution = 0;
  for (const TimedMove& move : moves.moves) {
    if (move.stopped != 0 || !span.shows(move)) continue;
    samples.push_back({span.of(move), move.cause, move.input, moves.unit});
    resolution = std::max(resolution, sources[move.input].resolution);
  }
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.duration < b.duration; });
  const std::vector<Time> kept = kept_durations(samples, clusters_of(samples, resolution));
  if (kept.size() < 2) return std::nullopt;
  const auto n = static_cast<double>(kept.size());
  double sum = 0;
  for (const Time time : kept) sum += static_cast<double>(time);
  double squares = 0;
  for (const Time time : kept) squares += std::pow(static_cast<double>(time) - sum / n, 2);
  const Baseline baseline{moves.unit,
                          moves.from,
                          moves.to,
                          moves.transition,
                          span.name,
                          kept.size(),
                          std::llround(sum / n),
                          std::llround(std::sqrt(squares / (n - 1)))};
  // The delay of a command is too short to be measured, unless it is all that shows.
  const bool is_delay = &span == &kSpans[0] && moves.moves.front().shows_arrival();
  return is_delay && baseline.mean <= 2 * resolution ? std::nullopt : std::optional(baseline);
}

}  // namespace

std::vector<Baseline> baselines_of(const TransitionMoves& moves, const std::vector<Source>& sources) {
  std::vector<Baseline> baselines;
  for (const MeasuredSpan& span : kSpans) {
    if (const auto baseline = baseline_of(moves, span, sources)) baselines.push_back(*baseline);
  }
  return baselines;
}

}  // namespace symplant::learn

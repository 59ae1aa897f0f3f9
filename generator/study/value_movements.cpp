// Movements of numeric symbols: from rest to rest.
#include <algorithm>
#include <cmath>
#include <optional>

#include "study/movement.hpp"

namespace symplant::study {
namespace {

using Change = recording::Series::Change;

constexpr double kBand = 0.002;                     // of the range: a number within it is at rest
constexpr double kMostNoise = 4;                    // of noise: so far from where it is, it moves
constexpr double kShortest = 0.05;                  // of the range: what moves less is not compared
constexpr Time kLongestWait = 3 * tables::kSecond;  // from a command to the first change of the number
constexpr Time kLeastRest = 500 * tables::kMillisecond;
constexpr Time kReadings = 5;   // that a number at rest is the same
constexpr Time kPoints = 1000;  // at which a movement is compared, without a resolution

/// The changes of a number that begins again after a period as if it went on.
std::vector<Change> unwrapped(const recording::Series* series, double period) {
  if (series == nullptr) return {};
  std::vector<Change> changes = series->changes;
  if (period <= 0) return changes;
  double turns = 0;
  for (std::size_t i = 1; i < changes.size(); ++i) {
    const double step = series->changes[i].value - series->changes[i - 1].value;
    turns -= std::round(step / period);
    changes[i].value += turns * period;
  }
  return changes;
}

/// A number over time. Times must not decrease from call to call.
class Walk {
 public:
  explicit Walk(const std::vector<Change>& changes) : changes_(changes) {}
  double operator()(Time time) {
    while (at_ < changes_.size() && changes_[at_].time <= time) value_ = changes_[at_++].value;
    return value_;
  }

 private:
  const std::vector<Change>& changes_;
  std::size_t at_ = 0;
  double value_ = 0;
};

/// When a number leaves its band for the first time, and for the last.
struct Stretch {
  Time first;
  Time last;
};

std::vector<Stretch> stretches(const std::vector<Change>& changes, double band, Time rest, Time end) {
  std::vector<Stretch> found;
  if (changes.empty()) return found;
  double anchor = changes.front().value;
  for (const Change& change : changes) {
    if (std::abs(change.value - anchor) <= band) continue;
    anchor = change.value;
    if (found.empty() || change.time - found.back().last > rest) found.push_back({change.time, change.time});
    found.back().last = change.time;
  }
  if (!found.empty() && end - found.back().last < rest) found.pop_back();  // it may go on
  return found;
}

/// The first of the commands that follow each other up to the first change; nothing: no command causes it.
std::optional<Time> command_of(const std::vector<Time>& commands, Time after, Time first, Time rest) {
  auto at = std::upper_bound(commands.begin(), commands.end(), first);
  if (at == commands.begin() || first - *std::prev(at) > kLongestWait || *std::prev(at) < after) return std::nullopt;
  --at;
  while (at != commands.begin() && *std::prev(at) >= after && *at - *std::prev(at) <= rest) --at;
  return *at;
}

bool has_gap(const Recorded& of, Time begin, Time end) {
  return std::any_of(of.gaps.begin(), of.gaps.end(),
                     [&](const recording::Gap& gap) { return gap.begin <= end && gap.begin + gap.length >= begin; });
}

}  // namespace

double accuracy_of(double mean_difference, double distance) {
  if (!(distance > 0)) return 0;
  return std::max(0.0, 1 - mean_difference / distance);
}

Time rest_time(Time resolution) { return std::max(kLeastRest, kReadings * resolution); }

std::vector<Movement> movements_of(const Curve& curve, const Recorded& of) {
  const std::vector<Change> recorded = unwrapped(curve.recorded, curve.period);
  const std::vector<Change> actual = unwrapped(curve.actual, curve.period);
  std::vector<Movement> movements;
  if (recorded.empty()) return movements;
  const auto by_value = [](const Change& a, const Change& b) { return a.value < b.value; };
  const auto [least, most] = std::minmax_element(recorded.begin(), recorded.end(), by_value);
  const double range = most->value - least->value;
  const double band = std::max({kBand * range, curve.whole ? 1.0 : 0.0, kMostNoise * curve.noise});
  const Time rest = rest_time(of.resolution);
  Walk recorded_at(recorded);
  Walk actual_at(actual);
  Time after = 0;
  for (const auto& [first, last] : stretches(recorded, band, rest, of.end)) {
    const std::optional<Time> begin = command_of(curve.commands, after, first, rest);
    after = last;
    if (!begin || has_gap(of, *begin, last)) continue;
    const double recorded_from = recorded_at(*begin);
    const double actual_from = actual_at(*begin);
    const Time step = of.resolution > 0 ? of.resolution : std::max<Time>((last - *begin) / kPoints, 1);
    double sum = 0;
    double moved = 0;
    std::size_t points = 0;
    for (Time time = first - (first - *begin) / step * step; time <= last; time += step, ++points) {
      moved = recorded_at(time) - recorded_from;
      sum += std::abs(moved - (actual_at(time) - actual_from));
    }
    moved = recorded_at(last) - recorded_from;
    if (std::abs(moved) < kShortest * range) continue;
    movements.push_back(
        {curve.recorded->name, *begin, last, accuracy_of(sum / static_cast<double>(points), std::abs(moved))});
  }
  return movements;
}

}  // namespace symplant::study

// Finds the change of an event that follows each change of an operation.
#include "learn/follow.hpp"

#include <algorithm>

namespace symplant::learn {
namespace {

/// Walks through changes of an operation and of an event together.
class Walk {
 public:
  Walk(const Edges& operation, const Edges& event, const Timeline& timeline)
      : operation_(operation), event_(event), timeline_(timeline) {}

  void run() {
    delays.reserve(operation_.times.size());
    for (std::size_t i = 0; i < operation_.times.size(); ++i) take(i);
    std::sort(delays.begin(), delays.end());
  }

  std::vector<Time> delays;  ///< of the first change of the event that follows, sorted
  std::vector<Time> cut;     ///< how much is left of the recording after changes that nothing follows
  std::size_t missed = 0;

 private:
  void take(std::size_t i) {
    const Time time = operation_.times[i];
    if (value_before(time) == event_.on) return;
    while (stretch_ + 1 < timeline_.stretches.size() && timeline_.stretches[stretch_].end < time) ++stretch_;
    const Time next = i + 1 < operation_.times.size() ? operation_.times[i + 1] : tables::kNever;
    const Time end = timeline_.stretches[stretch_].end;
    while (effect_ < event_.times.size() && event_.times[effect_] < time) ++effect_;
    const Time effect = effect_ < event_.times.size() ? event_.times[effect_] : tables::kNever;
    if (effect < next && effect <= end && effect - time <= kLongestDelay) {
      delays.push_back(effect - time);
    } else if (next > end && end - time < kLongestDelay) {
      cut.push_back(end - time);
    } else {
      ++missed;
    }
  }

  /// The value of the event just before a time.
  bool value_before(Time time) {
    const std::vector<Track::Value>& values = event_.track.values;
    while (value_ < values.size() && values[value_].time < time) ++value_;
    return value_ > 0 && values[value_ - 1].on;
  }

  const Edges& operation_;
  const Edges& event_;
  const Timeline& timeline_;
  std::size_t effect_ = 0;
  std::size_t value_ = 0;
  std::size_t stretch_ = 0;
};

struct Range {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// Most of the delays that are the same time.
Range same_time(const std::vector<Time>& delays, Time resolution) {
  Range best;
  std::size_t first = 0;
  for (std::size_t last = 0; last < delays.size(); ++last) {
    while (delays[last] - delays[first] > spread_allowed(delays[first], delays[last], resolution)) ++first;
    if (last - first + 1 > best.count) best = {first, last - first + 1};
  }
  return best;
}

}  // namespace

Follows follow(const Edges& operation, const Edges& event, const Timeline& timeline) {
  Walk walk(operation, event, timeline);
  walk.run();
  const std::vector<Time>& delays = walk.delays;
  Follows follows;
  follows.changes = delays.size() + walk.missed;
  if (delays.empty()) return follows;

  const Range same = same_time(delays, timeline.resolution);
  follows.hits = same.count;
  follows.least = delays[same.first];
  follows.most = delays[same.first + same.count - 1];
  follows.median = delays[same.first + same.count / 2];
  follows.changes += static_cast<std::size_t>(
      std::count_if(walk.cut.begin(), walk.cut.end(), [&](Time left) { return left > follows.most; }));
  follows.effects = static_cast<std::size_t>(std::count_if(event.times.begin(), event.times.end(), [&](Time time) {
    return time - follows.most >= timeline.stretch_of(time).begin;
  }));
  follows.central = std::max<std::size_t>(1, std::min(hits_needed(follows.changes), delays.size() - 1));
  const std::span<const Time> all(delays);
  follows.deviation = deviation_of(all.subspan(closest(all, follows.central), follows.central)) / tables::kSecond;
  return follows;
}

}  // namespace symplant::learn

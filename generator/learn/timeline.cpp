// Joins recordings to one axis of time.
#include "learn/timeline.hpp"

#include <algorithm>
#include <cstddef>

namespace symplant::learn {
namespace {

using recording::Recording;
using recording::Series;

/// Where a recording without lines between two others still has a length.
constexpr Time kBetweenRecordings = tables::kSecond;

Time first_time(const Recording& recording) {
  if (recording.of_plant || recording.order.empty()) return 0;
  return recording.series[recording.order.front()].changes.front().time;
}

/// The times in which a recording has no gap, on its own axis.
std::vector<Stretch> stretches_of(const Recording& recording) {
  std::vector<Stretch> stretches;
  Time begin = first_time(recording);
  for (const recording::Gap& gap : recording.gaps) {
    if (gap.begin > begin) stretches.push_back({begin, gap.begin});
    begin = std::max(begin, gap.begin + gap.length);
  }
  if (recording.end >= begin) stretches.push_back({begin, recording.end});
  return stretches;
}

/// Appends the changes of a series. Those of the first reading of a stretch may have happened at any time before it.
void take(const Series& series, const std::vector<Stretch>& stretches, Time resolution, Time offset, Track& track) {
  bool on = false;
  // The symbol may have been on at the end of the recording before this one.
  if (!track.values.empty() && track.values.back().on) track.values.push_back({offset, false});
  std::size_t stretch = 0;
  for (const Series::Change& change : series.changes) {
    const bool value = change.value != 0;
    if (value == on) continue;
    on = value;
    track.values.push_back({change.time + offset, on});
    while (stretch < stretches.size() && stretches[stretch].end < change.time) ++stretch;
    if (stretch == stretches.size() || change.time <= stretches[stretch].begin + resolution) continue;
    (on ? track.rises : track.falls).push_back(change.time + offset);
  }
}

}  // namespace

const Stretch& Timeline::stretch_of(Time time) const {
  const auto after = std::upper_bound(stretches.begin(), stretches.end(), time,
                                      [](Time t, const Stretch& stretch) { return t < stretch.begin; });
  return after == stretches.begin() ? stretches.front() : *(after - 1);
}

Time Timeline::length() const {
  Time length = 0;
  for (const Stretch& stretch : stretches) length += stretch.end - stretch.begin;
  return length;
}

Timeline timeline_of(const std::vector<Input>& inputs, std::size_t symbols) {
  Timeline timeline;
  timeline.tracks.resize(symbols);
  Time offset = 0;
  for (const Input& input : inputs) {
    const Recording& recording = input.recording;
    const std::vector<Stretch> stretches = stretches_of(recording);
    timeline.resolution = std::max(timeline.resolution, recording.resolution);
    for (std::size_t s = 0; s < recording.series.size(); ++s) {
      const std::uint32_t symbol = input.matched.symbols[s];
      if (symbol == model::kNone || recording.series[s].kind != Series::Kind::boolean) continue;
      take(recording.series[s], stretches, recording.resolution, offset, timeline.tracks[symbol]);
    }
    for (const Stretch& stretch : stretches) {
      timeline.stretches.push_back({stretch.begin + offset, stretch.end + offset});
    }
    offset += recording.end + kBetweenRecordings;
  }
  return timeline;
}

}  // namespace symplant::learn

// Passes a recording on, time by time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "observe/matched.hpp"
#include "observe/observer.hpp"

namespace symplant::observe {

/// Calls `sink.set(symbol, value)` for the changes of each time and `sink.close(time)` after them, and
/// `sink.gap(begin, length)` for each gap, followed by a close() at its end. What has no lines in the trace of a plant
/// is off from the beginning. O(changes).
template <class Sink>
void replay(const recording::Recording& recording, const Matched& matched, Sink& sink) {
  std::vector<std::size_t> next(recording.series.size(), 0);
  std::size_t gap = 0;
  Time time = kUnknown;
  const auto pass_gaps = [&](Time until) {
    for (; gap < recording.gaps.size() && recording.gaps[gap].begin < until; ++gap) {
      const recording::Gap& lost = recording.gaps[gap];
      sink.gap(lost.begin, lost.length);
      if (lost.begin + lost.length < until) sink.close(lost.begin + lost.length);
    }
  };
  if (recording.of_plant) {
    for (std::uint32_t s = 0; s < matched.recorded.size(); ++s) sink.set(s, 0);
  }
  for (const std::uint32_t series : recording.order) {
    const recording::Series::Change& change = recording.series[series].changes[next[series]++];
    if (change.time != time && time != kUnknown) sink.close(time);
    time = change.time;
    pass_gaps(time);
    if (matched.symbols[series] != kNone) sink.set(matched.symbols[series], change.value);
  }
  if (time != kUnknown) sink.close(time);
  pass_gaps(recording.end);
}

}  // namespace symplant::observe

// Lets a watcher follow what is read of a plant, from a recording or a link.
#include "watch/shadow.hpp"

#include <utility>

namespace symplant::watch {

Shadow::Shadow(const model::PlantModel& plant, const std::vector<bool>& recorded, const Margin& margin,
               const std::vector<Statistic>& learned, Watcher::Report report)
    : plant_(plant),
      observer_(plant, recorded, margin.resolution),
      watcher_(plant, recorded, observer_, margin, learned, std::move(report)) {}

void Shadow::close(Time time) {
  watcher_.time(time);
  for (const Change& change : changes_) {
    const model::Symbol& symbol = plant_.symbols[change.symbol];
    if (symbol.unit != kNone && symbol.direction == tables::Direction::operation) {
      watcher_.command(time, change.symbol, (change.value != 0) != symbol.inverted);
    }
    observer_.set(change.symbol, change.value);
  }
  changes_.clear();
  for (const observe::Step& step : observer_.close(time)) watcher_.step(time, step);
}

void Shadow::gap(Time begin, Time length) {
  watcher_.time(begin);
  watcher_.gap(begin + length, length);
  observer_.forget();
}

void follow(const recording::Recording& recording, const observe::Matched& matched, Shadow& shadow) {
  std::vector<std::size_t> next(recording.series.size(), 0);
  std::size_t gap = 0;
  Time time = kUnknown;
  const auto pass_gaps = [&](Time until) {
    for (; gap < recording.gaps.size() && recording.gaps[gap].begin < until; ++gap) {
      const recording::Gap& lost = recording.gaps[gap];
      shadow.gap(lost.begin, lost.length);
      if (lost.begin + lost.length < until) shadow.close(lost.begin + lost.length);
    }
  };
  if (recording.of_plant) {  // what has no lines is off from the beginning
    for (std::uint32_t s = 0; s < matched.recorded.size(); ++s) shadow.set(s, 0);
  }
  for (const std::uint32_t series : recording.order) {
    const recording::Series::Change& change = recording.series[series].changes[next[series]++];
    if (change.time != time && time != kUnknown) shadow.close(time);
    time = change.time;
    pass_gaps(time);
    if (matched.symbols[series] != kNone) shadow.set(matched.symbols[series], change.value);
  }
  if (time != kUnknown) shadow.close(time);
  pass_gaps(recording.end);
  shadow.finish(recording.end);
}

}  // namespace symplant::watch

// Lets a watcher follow what is read of a plant, from a recording or a link.
#include "watch/shadow.hpp"

#include <utility>

#include "observe/replay.hpp"

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
  observe::replay(recording, matched, shadow);
  shadow.finish(recording.end);
}

}  // namespace symplant::watch

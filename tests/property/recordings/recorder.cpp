// Recordings from values.
#include "property/recordings/recorder.hpp"

#include <algorithm>
#include <utility>

namespace symplant::property {

using recording::Series;

Recorder::Recorder(const model::PlantModel& plant, tables::Time resolution)
    : plant_(plant), series_(plant.symbols.size(), model::kNone) {
  recording_.name = "recorded";
  recording_.resolution = resolution;
  recording_.of_plant = resolution == 0;
}

void Recorder::note(tables::Time time, std::uint32_t symbol, double value) {
  std::uint32_t& index = series_[symbol];
  if (index == model::kNone) {
    index = static_cast<std::uint32_t>(recording_.series.size());
    const model::Symbol& of = plant_.symbols[symbol];
    Series series;
    series.name = of.name();
    series.kind = of.type == tables::DataType::boolean ? Series::Kind::boolean : Series::Kind::number;
    series.is_operation = of.direction == tables::Direction::operation;
    recording_.index.emplace(series.key(), index);
    recording_.series.push_back(std::move(series));
  }
  std::vector<Series::Change>& changes = recording_.series[index].changes;
  if (changes.empty() || changes.back().value != value) changes.push_back({time, value});
}

recording::Recording Recorder::finish(tables::Time end) {
  struct Key {
    tables::Time time;
    bool event;
    std::uint32_t series;
  };
  std::vector<Key> keys;
  for (std::uint32_t s = 0; s < recording_.series.size(); ++s) {
    for (const Series::Change& change : recording_.series[s].changes) {
      keys.push_back({change.time, !recording_.series[s].is_operation, s});
    }
  }
  std::stable_sort(keys.begin(), keys.end(),
                   [](const Key& a, const Key& b) { return a.time != b.time ? a.time < b.time : a.event < b.event; });
  for (const Key& key : keys) recording_.order.push_back(key.series);
  recording_.end = end;
  return std::move(recording_);
}

}  // namespace symplant::property

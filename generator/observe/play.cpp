// Lets an observer follow a recording.
#include "observe/play.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <unordered_map>

#include "observe/addresses.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::observe {
namespace {

using recording::Recording;
using recording::Series;

constexpr std::size_t kMostSuggested = 20;

void suggest(const model::PlantModel& plant, Matched& matched) {
  for (std::size_t i = 0; i < std::min(kMostSuggested, matched.unknown.size()); ++i) {
    tables::NearestName nearest(matched.unknown[i].name);
    for (std::uint32_t s = 0; s < plant.symbols.size(); ++s) {
      if (!matched.recorded[s]) nearest.offer(plant.symbols[s].name());
    }
    matched.unknown[i].nearest = nearest.name();
  }
}

class Player {
 public:
  Player(const Recording& recording, const Matched& matched, Observer& observer,
         const std::function<void(Time, const Step&)>& step)
      : recording_(recording), matched_(matched), observer_(observer), step_(step), next_(recording.series.size(), 0) {}

  void run() {
    if (recording_.of_plant) {  // what has no lines is off from the beginning
      for (std::uint32_t s = 0; s < matched_.recorded.size(); ++s) observer_.set(s, 0);
    }
    for (const std::uint32_t series : recording_.order) {
      const Series::Change& change = recording_.series[series].changes[next_[series]++];
      if (change.time != time_) close();
      time_ = change.time;
      pass_gaps();
      if (matched_.symbols[series] != kNone) observer_.set(matched_.symbols[series], change.value);
    }
    close();
  }

 private:
  void close() {
    if (time_ == kUnknown) return;
    for (const Step& step : observer_.close(time_)) step_(time_, step);
  }

  void pass_gaps() {
    for (; gap_ < recording_.gaps.size() && recording_.gaps[gap_].begin < time_; ++gap_) {
      observer_.forget();
      const Time end = recording_.gaps[gap_].begin + recording_.gaps[gap_].length;
      if (end < time_) observer_.close(end);
    }
  }

  const Recording& recording_;
  const Matched& matched_;
  Observer& observer_;
  const std::function<void(Time, const Step&)>& step_;
  std::vector<std::size_t> next_;  ///< by series: its next change
  std::size_t gap_ = 0;
  Time time_ = kUnknown;
};

}  // namespace

Matched match(const model::PlantModel& plant, const Recording& recording) {
  Matched matched;
  matched.recorded.resize(plant.symbols.size(), recording.of_plant);
  std::unordered_map<std::string_view, std::uint32_t> names;
  for (std::uint32_t s = 0; s < plant.symbols.size(); ++s) names.emplace(plant.symbols[s].name(), s);
  std::vector<bool> taken(plant.symbols.size());
  for (const Series& series : recording.series) {
    const auto found = series.kind == Series::Kind::parts ? names.end() : names.find(series.name);
    matched.symbols.push_back(found == names.end() ? kNone : found->second);
    if (found != names.end()) taken[found->second] = matched.recorded[found->second] = true;
  }
  std::optional<Addresses> addresses;
  for (std::size_t s = 0; s < recording.series.size(); ++s) {
    const Series& series = recording.series[s];
    if (matched.symbols[s] != kNone || series.kind == Series::Kind::parts) continue;
    if (!addresses) addresses.emplace(plant);
    const std::uint32_t symbol = addresses->symbol_at(series.name);
    if (symbol == kNone || taken[symbol]) {
      matched.unknown.push_back({series.name, {}});
      continue;
    }
    matched.symbols[s] = symbol;
    taken[symbol] = matched.recorded[symbol] = true;
  }
  suggest(plant, matched);
  return matched;
}

Matched adopt(const model::PlantModel& plant, Recording& recording) {
  Matched matched = match(plant, recording);
  for (std::size_t s = 0; s < recording.series.size(); ++s) {
    if (matched.symbols[s] == kNone) continue;
    Series& series = recording.series[s];
    const model::Symbol& symbol = plant.symbols[matched.symbols[s]];
    if (series.name != symbol.name()) {
      recording.index.erase(series.key());
      series.name = symbol.name();
      recording.index.emplace(series.key(), s);
    }
    series.is_operation = symbol.direction == tables::Direction::operation;
    const bool is_bit = symbol.type == tables::DataType::boolean;
    series.kind = is_bit ? Series::Kind::boolean : Series::Kind::number;
    series.may_be_number = false;
    if (!is_bit) continue;
    for (Series::Change& change : series.changes) change.value = change.value != 0 ? 1 : 0;
  }
  recording::order_operations(recording);
  return matched;
}

void play(const Recording& recording, const Matched& matched, Observer& observer,
          const std::function<void(Time, const Step&)>& step) {
  Player(recording, matched, observer, step).run();
}

std::vector<Move> moves_of(const model::PlantModel& plant, const Recording& recording, const Matched& matched) {
  Observer observer(plant, matched.recorded, recording.resolution);
  std::vector<Move> moves;
  play(recording, matched, observer, [&](Time, const Step& step) {
    const bool ends = step.kind == Step::Kind::arrived ||
                      (step.kind == Step::Kind::left && step.move.to != kNone && !observer.view(step.move.unit).moving);
    if (ends) moves.push_back(step.move);
  });
  return moves;
}

}  // namespace symplant::observe

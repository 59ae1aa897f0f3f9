// How accurately a plant repeats a recording.
#include "study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "study/causes.hpp"
#include "study/run.hpp"
#include "study/shown.hpp"
#include "study/start.hpp"
#include "symplant/condition/type_info.hpp"

namespace symplant::study {
namespace {

/// The series of each symbol of the plant; null: the recording does not have it.
std::vector<const recording::Series*> series_of_symbols(const recording::Recording& recording,
                                                        const observe::Matched& matched, std::size_t symbols) {
  std::vector<const recording::Series*> all(symbols);
  for (std::size_t s = 0; s < recording.series.size(); ++s) {
    if (matched.symbols[s] != model::kNone) all[matched.symbols[s]] = &recording.series[s];
  }
  return all;
}

/// When operations change, each time once. What they are at the beginning is no change.
std::vector<Time> command_times(const std::vector<std::uint32_t>& operations,
                                const std::vector<const recording::Series*>& series, Time begin) {
  std::vector<Time> times;
  for (const std::uint32_t operation : operations) {
    if (series[operation] == nullptr) continue;
    for (const recording::Series::Change& change : series[operation]->changes) {
      if (change.time > begin) times.push_back(change.time);
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

bool is_chosen(const model::PlantModel& plant, const model::Unit& unit,
               const std::function<bool(std::string_view)>& chosen) {
  return std::any_of(unit.events.begin(), unit.events.end(),
                     [&](std::uint32_t event) { return chosen(plant.symbols[event].name()); });
}

void add_signals(const model::PlantModel& plant, const recording::Recording& recording, const observe::Matched& matched,
                 const observe::Matched& matched_run, const std::function<bool(std::string_view)>& chosen,
                 const Recorded& of, Study& result) {
  const auto recorded = series_of_symbols(recording, matched, plant.symbols.size());
  const auto actual = series_of_symbols(result.run, matched_run, plant.symbols.size());
  const auto operations = operations_of_signals(plant);
  for (std::size_t s = 0; s < plant.signals.size(); ++s) {
    const std::uint32_t symbol = plant.signals[s].row.symbol;
    if (recorded[symbol] == nullptr || !chosen(recorded[symbol]->name)) continue;
    Curve curve;
    curve.recorded = recorded[symbol];
    curve.actual = actual[symbol];
    curve.commands = command_times(operations[s], recorded, result.begin);
    curve.period = period_of(plant.signals[s]);
    curve.whole = condition::info_of(plant.symbols[symbol].type).kind != tables::NumberKind::real;
    curve.noise = plant.signals[s].row.noise;
    const std::vector<Movement> own = movements_of(curve, of);
    result.movements.insert(result.movements.end(), own.begin(), own.end());
  }
}

void add_devices(const model::PlantModel& plant, const recording::Recording& recording, const observe::Matched& matched,
                 const observe::Matched& matched_run, const std::function<bool(std::string_view)>& chosen,
                 const Recorded& of, Study& result) {
  const auto moves = [&](const recording::Recording& one, const observe::Matched& by) {
    std::vector<observe::Move> found = observe::moves_of(plant, one, by);
    std::erase_if(found, [&](const observe::Move& move) { return !is_chosen(plant, plant.units[move.unit], chosen); });
    return found;
  };
  // The recording may begin while a device moves; a trace of a plant begins with the plant.
  const Time begin = recording.of_plant ? -1 : result.begin;
  const std::vector<Movement> all =
      movements_of(plant, moves(recording, matched), moves(result.run, matched_run), begin, of);
  result.movements.insert(result.movements.end(), all.begin(), all.end());
}

void add(const Movement& movement, Row& row, double& duration) {
  const auto weight = static_cast<double>(movement.duration());
  ++row.count;
  row.least = std::min(row.least, movement.accuracy);
  row.greatest = std::max(row.greatest, movement.accuracy);
  row.mean += movement.accuracy * weight;
  duration += weight;
}

}  // namespace

std::vector<Row> rows_of(const std::vector<Movement>& movements) {
  std::map<std::string, std::vector<Movement>> by_name;
  for (const Movement& movement : movements) by_name[movement.name].push_back(movement);
  std::vector<Row> rows;
  for (const auto& [name, own] : by_name) {
    rows.push_back(total_of(own));
    rows.back().name = name;
  }
  return rows;
}

Row total_of(const std::vector<Movement>& movements) {
  Row total{"total"};
  double duration = 0;
  for (const Movement& movement : movements) add(movement, total, duration);
  if (duration > 0) total.mean /= duration;
  return total;
}

Study study(const model::PlantModel& plant, const tables::PlantTables& tables, const recording::Recording& recording,
            const std::string& plant_file, const std::function<bool(std::string_view)>& chosen) {
  Study result;
  const observe::Matched matched = observe::match(plant, recording);
  for (const observe::Matched::Unknown& unknown : matched.unknown) {
    result.unmatched.push_back(observe::words_of(unknown));
  }
  const Start start = start_of(plant, recording, matched);
  result.run = run_with(plant, tables, recording, matched, start, fmt::format("run of {}", plant_file));
  result.resolution = recording.resolution;
  result.begin = start.begin;
  result.states = start.states.size();
  result.numbers = start.numbers.size();
  result.unknown = start.unknown;
  const observe::Matched matched_run = observe::match(plant, result.run);
  const Recorded of{recording.end, recording.resolution, recording.gaps};
  add_signals(plant, recording, matched, matched_run, chosen, of, result);
  add_devices(plant, recording, matched, matched_run, chosen, of, result);
  std::stable_sort(result.movements.begin(), result.movements.end(),
                   [](const Movement& a, const Movement& b) { return a.end < b.end; });
  result.rows = rows_of(result.movements);
  result.total = total_of(result.movements);
  return result;
}

}  // namespace symplant::study

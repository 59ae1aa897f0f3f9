// The state in which a recording begins.
#include "study/start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "elements/value/readers.hpp"
#include "observe/observer.hpp"
#include "study/shown.hpp"
#include "symplant/condition/type_info.hpp"

namespace symplant::study {
namespace {

/// The first lines of a recording, one a symbol, have different times if the symbols were read by several requests.
constexpr Time kFirstLines = 2;    // resolutions
constexpr double kDeviations = 4;  // of noise
constexpr double kRounding = 0.5;  // of a number that is an integer

Time begin_of(const recording::Recording& recording) {
  if (recording.of_plant) return 0;
  Time first = std::numeric_limits<Time>::max();
  for (const recording::Series& series : recording.series) {
    if (!series.changes.empty()) first = std::min(first, series.changes.front().time);
  }
  Time begin = 0;
  for (const recording::Series& series : recording.series) {
    if (series.changes.empty()) continue;
    const Time at = series.changes.front().time;
    if (at - first <= kFirstLines * recording.resolution) begin = std::max(begin, at);
  }
  return begin;
}

/// The last value at or before a time.
std::optional<double> value_at(const recording::Series& series, Time time) {
  const auto after = std::upper_bound(series.changes.begin(), series.changes.end(), time,
                                      [](Time t, const recording::Series::Change& change) { return t < change.time; });
  if (after == series.changes.begin()) return std::nullopt;
  return std::prev(after)->value;
}

/// Finds the numbers of values from what signals show of them.
class Numbers {
 public:
  Numbers(const model::PlantModel& plant, Start& start)
      : plant_(plant), value_of_(model::values_of_outputs(plant)), set_(plant.values.size()), start_(start) {}

  void from(const model::Signal& signal, double number) {
    const std::optional<Line> line = line_of(signal);
    if (!line) return;
    const model::Value& value = plant_.values[value_of_[line->output]];
    const double shown = line->factor * value.row.start_output() + line->offset;
    const bool is_real = condition::info_of(plant_.symbols[signal.row.symbol].type).kind == tables::NumberKind::real;
    const double unsure = (is_real ? 0 : kRounding) + kDeviations * signal.row.noise;
    if (std::abs(shown - number) <= unsure) return;  // the start of the model may be exact
    set(line->output, line->output_for(number));
  }

 private:
  /// A value, and those that it follows at rest: a lag has the number of what it lags behind.
  void set(std::uint32_t output, double number) {
    for (std::optional<Line> line = Line{output}; line;) {
      const std::uint32_t v = value_of_[line->output];
      const model::Value& value = plant_.values[v];
      if (set_[v] || value.row.outputs != 1) return;
      set_[v] = true;
      const tables::ValueKind kind = value.row.kind;
      if (tables::keeps_its_output(kind)) start_.numbers.emplace_back(v, number);
      const bool follows = kind == tables::ValueKind::lag || kind == tables::ValueKind::is;
      line = follows ? line_of(value.formulas.front()) : std::nullopt;
      if (line) number = line->output_for(number);
    }
  }

  const model::PlantModel& plant_;
  std::vector<std::uint32_t> value_of_;
  std::vector<bool> set_;  ///< by value
  Start& start_;
};

void find_states(const model::PlantModel& plant, const recording::Recording& recording, const observe::Matched& matched,
                 Start& start) {
  observe::Observer observer(plant, matched.recorded, recording.resolution);
  if (recording.of_plant) {  // what has no line is off
    for (std::uint32_t s = 0; s < plant.symbols.size(); ++s) observer.set(s, 0);
  }
  for (std::size_t s = 0; s < recording.series.size(); ++s) {
    if (start.known[s] && matched.symbols[s] != model::kNone) observer.set(matched.symbols[s], start.values[s]);
  }
  observer.close(start.begin);
  for (std::uint32_t u = 0; u < plant.units.size(); ++u) {
    if (!plant.units[u].moves() || plant.units[u].events.empty()) continue;
    const observe::View view = observer.view(u);
    if (view.state == model::kNone) {
      ++start.unknown;
    } else if (view.state != plant.units[u].initial && !view.contradicts) {
      start.states.emplace_back(u, static_cast<std::uint8_t>(view.state));
    }
  }
}

}  // namespace

Start start_of(const model::PlantModel& plant, const recording::Recording& recording, const observe::Matched& matched) {
  Start start;
  start.begin = begin_of(recording);
  for (const recording::Series& series : recording.series) {
    const std::optional<double> value = value_at(series, start.begin);
    start.values.push_back(value.value_or(0));
    start.known.push_back(value || recording.of_plant);
  }
  find_states(plant, recording, matched, start);
  Numbers numbers(plant, start);
  for (const model::Signal& signal : plant.signals) {
    const auto found = std::find(matched.symbols.begin(), matched.symbols.end(), signal.row.symbol);
    if (found == matched.symbols.end()) continue;
    const auto series = static_cast<std::size_t>(found - matched.symbols.begin());
    if (start.known[series]) numbers.from(signal, start.values[series]);
  }
  return start;
}

}  // namespace symplant::study

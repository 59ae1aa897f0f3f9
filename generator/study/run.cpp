// Runs a plant with the operations of a recording.
#include "study/run.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "recording/of_run.hpp"
#include "symplant/plant/owned_plant.hpp"
#include "symplant/trace/plant_names.hpp"
#include "symplant/trace/recorder.hpp"
#include "symplant/trace/value_text.hpp"

namespace symplant::study {
namespace {

std::uint64_t slot_value(tables::DataType type, double number) {
  constexpr double kMost = 9.2e18;  // fits in both kinds of integers
  if (trace::is_real(type)) return std::bit_cast<std::uint64_t>(number);
  if (std::isnan(number)) return 0;
  if (!trace::is_signed(type)) return static_cast<std::uint64_t>(std::clamp(number, 0.0, kMost));
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::clamp(number, -kMost, kMost)));
}

/// Times of the recording begin at Start::begin, those of the plant at 0.
class Run {
 public:
  Run(const tables::PlantTables& tables, const recording::Recording& recording, const observe::Matched& matched,
      const Start& start)
      : tables_(tables),
        recording_(recording),
        matched_(matched),
        start_(start),
        plant_(tables),
        recorder_(tables, trace::Recorder::enough_for_a_loop(tables)),
        next_(recording.series.size()),
        written_at_(recording.series.size(), -1) {
    plant_.reset();
    recorder_.attach(plant_);
  }

  std::vector<recording::RunChange> run() {
    begin();
    for (const std::uint32_t s : recording_.order) {
      const recording::Series::Change& change = recording_.series[s].changes[next_[s]++];
      const std::uint32_t symbol = matched_.symbols[s];
      if (change.time <= start_.begin || symbol == tables::kNone) continue;
      const Time time = change.time - start_.begin;
      go_before(time);
      if (std::exchange(written_at_[s], time) == time) advance_to(time);  // it changes twice at one time
      write(symbol, change.value);
    }
    const Time end = recording_.end - std::min(start_.begin, recording_.end);
    go_before(end);
    advance_to(end);
    return std::move(changes_);
  }

 private:
  void begin() {
    for (const auto& [unit, state] : start_.states) plant_.set_state(unit, state);
    for (const auto& [value, number] : start_.numbers) plant_.set_value(value, number);
    if (recording_.of_plant) {
      for (std::uint32_t symbol = 0; symbol < tables_.symbols.size(); ++symbol) write(symbol, 0);  // without a line
    }
    for (std::size_t s = 0; s < recording_.series.size(); ++s) {
      if (start_.known[s] && matched_.symbols[s] != tables::kNone) write(matched_.symbols[s], start_.values[s]);
    }
  }

  /// Runs what is due before a time, instant by instant, so that the records have room.
  void go_before(Time time) {
    if (plant_.now() >= time) return;
    advance_to(plant_.now());  // what was written last takes effect at its time
    for (Time due = plant_.next_due(); due < time; due = plant_.next_due()) advance_to(due);
    plant_.advance_before(time, &recorder_);
  }

  void advance_to(Time time) {
    plant_.advance_to(time, &recorder_);
    recorder_.drain([this](const trace::Record& record) {
      if (record.kind != trace::Record::Kind::change) return;
      changes_.push_back({record.time + start_.begin, record.value, record.of});
    });
  }

  /// An event that the plant drives stays as it is.
  void write(std::uint32_t symbol, double number) {
    const tables::SymbolRow& row = tables_.symbols[symbol];
    const bool is_bit = row.type() == tables::DataType::boolean;
    if (row.direction() == tables::Direction::event) {
      plant_.set_input(symbol, is_bit ? (number != 0 ? 1 : 0) : slot_value(row.type(), number));
    } else if (is_bit) {
      plant_.set_operation(row.index, number != 0);
    } else {
      plant_.set_operation_value(row.index, slot_value(row.type(), number));
    }
  }

  const tables::PlantTables& tables_;
  const recording::Recording& recording_;
  const observe::Matched& matched_;
  const Start& start_;
  plant::OwnedPlant plant_;
  trace::Recorder recorder_;
  std::vector<std::size_t> next_;  ///< by series: its next change
  std::vector<Time> written_at_;   ///< by series: when its last change was written, in plant time
  std::vector<recording::RunChange> changes_;
};

/// A recording begins with a line of each symbol, a run with a line of those that are on or not 0.
void add_first_lines(std::vector<recording::RunChange>& changes, std::size_t symbols, Time begin) {
  std::vector<bool> has_line(symbols);
  for (const recording::RunChange& change : changes) {
    if (change.time > begin) break;
    has_line[change.of] = true;
  }
  std::vector<recording::RunChange> first;
  for (std::uint32_t symbol = 0; symbol < symbols; ++symbol) {
    if (!has_line[symbol]) first.push_back({begin, 0, symbol});
  }
  changes.insert(changes.begin(), first.begin(), first.end());
}

}  // namespace

recording::Recording run_with(const model::PlantModel& plant, const tables::PlantTables& tables,
                              const recording::Recording& recording, const observe::Matched& matched,
                              const Start& start, std::string name) {
  std::vector<recording::RunChange> changes = Run(tables, recording, matched, start).run();
  if (!recording.of_plant) add_first_lines(changes, plant.symbols.size(), start.begin);
  const trace::PlantNames names(tables);
  const std::vector<bool> all(plant.symbols.size(), true);
  recording::Recording run = recording::of_run(changes, recording.end, names, all, std::move(name));
  run.of_plant = recording.of_plant;
  return run;
}

}  // namespace symplant::study

// Lock step of a plant and its program, seen by a recorder.
#include "property/recordings/recorded_run.hpp"

#include <bit>
#include <cstddef>
#include <memory>
#include <optional>

#include "lower/lower.hpp"
#include "property/engine_plant.hpp"
#include "property/recordings/recorder.hpp"
#include "symplant/condition/type_info.hpp"
#include "symplant/tables/compare.hpp"

namespace symplant::property {
namespace {

using tables::Time;

constexpr Time kScan = 10 * tables::kMillisecond;

class Run final : private engine::Observer {
 public:
  Run(const model::PlantModel& model, const RunOptions& options)
      : model_(model),
        options_(options),
        lowered_(lower::lower(model)),
        tables_(lowered_.tables()),
        indexes_(tables_),
        memory_(
            std::make_unique<std::max_align_t[]>(plant::Plant::memory_size(tables_) / sizeof(std::max_align_t) + 1)),
        plant_(tables_, std::span(reinterpret_cast<std::byte*>(memory_.get()), plant::Plant::memory_size(tables_))),
        recorder_(model, options.every) {}

  RecordedRun run() {
    Dice dice(options_.seed + 77);
    plant_.reset(options_.seed, 0);
    truth_.emplace(plant_);
    RandomCommands program(options_.seed, model_, tables_, options_.commands);
    const Time scan_phase = static_cast<Time>(dice.below(kScan));
    Time scan = scan_phase;
    Time read = 0;
    advance(0);
    note_all(0);
    while (scan < options_.length) {
      for (; options_.every > 0 && read <= scan; read += options_.every) {
        advance(read);
        note_all(read);
      }
      advance(scan);
      program.scan(plant_, scan);
      advance(scan);  // what was written takes effect at once
      scan += kScan;
    }
    return {recorder_.finish(options_.length), truth_->moves()};
  }

 private:
  void advance(Time time) { plant_.advance_to(time, this); }

  void instant(const engine::Instant& instant) noexcept override {
    for (const std::uint32_t unit : instant.units) truth_->look(unit, instant.time);
    if (options_.every > 0 || instant.time == 0) return;
    note_bits(instant.time, instant.operations, indexes_.operation_bits);
    note_bits(instant.time, instant.events, indexes_.event_bits);
    for (const std::uint32_t slot : instant.operation_slots) note(instant.time, indexes_.operation_slots[slot]);
    for (const std::uint32_t slot : instant.event_slots) note(instant.time, indexes_.event_slots[slot]);
  }

  void note_bits(Time time, std::span<const engine::WordChange> words, const std::vector<std::uint32_t>& symbols) {
    for (const engine::WordChange& change : words) {
      for (std::uint64_t bits = change.bits; bits != 0; bits &= bits - 1) {
        note(time, symbols[change.word * 64 + static_cast<std::uint32_t>(std::countr_zero(bits))]);
      }
    }
  }

  void note_all(Time time) {
    for (std::uint32_t s = 0; s < model_.symbols.size(); ++s) note(time, s);
  }

  void note(Time time, std::uint32_t symbol) {
    if (symbol >= model_.symbols.size()) return;  // a bit that pads a word
    const tables::SymbolRow& row = tables_.symbols[symbol];
    const bool operation = row.direction() == tables::Direction::operation;
    double value = 0;
    if (row.type() == tables::DataType::boolean) {
      value = (operation ? plant_.operation(row.index) : plant_.event(row.index)) ? 1 : 0;
    } else {
      const std::uint64_t content = operation ? plant_.operation_value(row.index) : plant_.event_value(row.index);
      value = tables::number_of(condition::info_of(row.type()).kind, content);
    }
    recorder_.note(time, symbol, value);
  }

  const model::PlantModel& model_;
  const RunOptions& options_;
  const lower::EngineTables lowered_;
  const tables::PlantTables tables_;
  const SymbolIndexes indexes_;
  std::unique_ptr<std::max_align_t[]> memory_;
  plant::Plant plant_;
  Recorder recorder_;
  std::optional<TrueMoves> truth_;
};

}  // namespace

RecordedRun record_run(const model::PlantModel& plant, const RunOptions& options) { return Run(plant, options).run(); }

}  // namespace symplant::property

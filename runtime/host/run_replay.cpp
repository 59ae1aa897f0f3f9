// Runs a plant as a trace has it.
#include "symplant/host/run_replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "symplant/host/signals.hpp"
#include "symplant/scenario/act.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::host {
namespace {

using Deed = Replay::Deed;

/// The operations that a malfunction of the description lets flicker.
std::vector<std::uint32_t> flickering_operations(const tables::PlantTables& tables) {
  std::vector<std::uint32_t> symbols;
  for (const tables::MalfunctionRow& row : tables.malfunctions.rows) {
    const bool flickers = row.kind == tables::MalfunctionKind::flicker;
    if (flickers && tables.symbols[row.subject].direction() == tables::Direction::operation) {
      symbols.push_back(row.subject);
    }
  }
  return symbols;
}

class Replayer {
 public:
  Replayer(Stage& stage, const Replay& replay)
      : stage_(stage),
        plant_(stage.plant),
        replay_(replay),
        flickering_(flickering_operations(plant_.tables())),
        shown_(flickering_.size(), false),
        unseen_(plant_.tables(), trace::Recorder::enough_for_an_instant(plant_.tables())) {
    unseen_.attach(plant_);
    for (std::size_t i = 0; i < flickering_.size(); ++i) shown_[i] = shows(flickering_[i]);
  }

  bool over() const { return at_ == replay_.deeds.size(); }
  tables::Time next() const { return replay_.deeds[at_].time; }

  /// Runs the instants before `time`, one by one, so that their records have room; false if a signal came.
  bool go_before(tables::Time time) {
    for (tables::Time due = plant_.next_due(); due < time; due = plant_.next_due()) {
      if (stop_requested().load(std::memory_order_relaxed)) return false;
      run_instant(due, {});
    }
    plant_.advance_before(time, &stage_.recorder);
    return true;
  }

  void run_to(tables::Time time) { run_instant(time, {}); }

  /// Runs the next instant with something from outside, after those of its time that come before.
  void next_instant() {
    const Deed first = replay_.deeds[at_];
    uncover(first.time);
    for (std::uint64_t ran = stage_.recorder.instants_at(first.time); ran + 1 < first.instant;) {
      run_instant(first.time, {});
      const std::uint64_t now = stage_.recorder.instants_at(first.time);
      if (now == ran) break;  // of another model: there are not as many
      ran = now;
    }
    const std::size_t begin = at_;
    while (!over() && next() == first.time && replay_.deeds[at_].instant == first.instant) ++at_;
    run_instant(first.time, std::span(replay_.deeds).subspan(begin, at_ - begin));
  }

 private:
  /// What is written to an operation that may flicker.
  struct Written {
    std::uint32_t symbol;
    bool value;
  };

  void run_instant(tables::Time time, std::span<const Deed> deeds) {
    const std::vector<Written> written = flickering_.empty() ? std::vector<Written>() : written_below(time, deeds);
    run(time, deeds, written, stage_.recorder, &stage_.recorder);
    stage_.outputs.drain();
  }

  void run(tables::Time time, std::span<const Deed> deeds, std::span<const Written> written, trace::Recorder& notes,
           engine::Observer* observer) {
    for (const Deed& deed : deeds) {
      if (deed.kind != Deed::Kind::operation) act(deed, notes);
    }
    for (const Deed& deed : deeds) {
      if (deed.kind == Deed::Kind::operation && !flickers(deed.of)) write(deed.of, deed.value);
    }
    for (const Written& one : written) write(one.symbol, one.value ? 1 : 0);
    plant_.advance_to(time, observer);
  }

  /// A trace has what an operation shows, which is the contrary of what was written while it flickers. The writes with
  /// which those operations show what the trace has are found by trying: nothing, the shown value, the contrary.
  std::vector<Written> written_below(tables::Time time, std::span<const Deed> deeds) {
    for (const Deed& deed : deeds) {
      for (std::size_t i = 0; i < flickering_.size(); ++i) {
        if (deed.kind == Deed::Kind::operation && deed.of == flickering_[i]) shown_[i] = deed.value != 0;
      }
    }
    const std::span<const std::byte> block = plant_.save();
    const std::vector<std::byte> before(block.begin(), block.end());
    std::vector<Written> written;
    for (int attempt = 0; attempt < 3; ++attempt) {
      run(time, deeds, written, unseen_, nullptr);
      bool well = true;
      for (std::size_t i = 0; i < flickering_.size(); ++i) {
        if (shows(flickering_[i]) == shown_[i]) continue;
        well = false;
        const auto tried = std::find_if(written.begin(), written.end(),
                                        [&](const Written& one) { return one.symbol == flickering_[i]; });
        if (tried != written.end()) tried->value = !tried->value;
        if (tried == written.end()) written.push_back({flickering_[i], shown_[i]});
      }
      plant_.restore(before);
      if (well) break;
    }
    return written;
  }

  bool flickers(std::uint32_t symbol) const {
    return std::find(flickering_.begin(), flickering_.end(), symbol) != flickering_.end();
  }
  bool shows(std::uint32_t symbol) const { return plant_.operation(plant_.tables().symbols[symbol].index); }

  /// A trace has what operations show. What was written to one that is held, by a force or a malfunction, shows when
  /// that ends, and a malfunction may end within an earlier instant of this time than the one that shows it.
  void uncover(tables::Time time) {
    for (std::size_t i = at_; i < replay_.deeds.size() && replay_.deeds[i].time == time; ++i) {
      const Deed& deed = replay_.deeds[i];
      if (deed.kind != Deed::Kind::operation) return;
      if (!flickers(deed.of) && plant_.malfunction_of_symbol(deed.of) != tables::kNone) write(deed.of, deed.value);
    }
  }

  void write(std::uint32_t symbol, std::uint64_t value) {
    const tables::SymbolRow& row = plant_.tables().symbols[symbol];
    if (row.type() == tables::DataType::boolean) {
      plant_.set_operation(row.index, value != 0);
    } else {
      plant_.set_operation_value(row.index, value);
    }
  }

  void act(const Deed& deed, trace::Recorder& notes) {
    const tables::Time now = plant_.now();
    notes.begin_act(now);
    if (deed.kind == Deed::Kind::quality) {
      notes.act(now, trace::kQualityNote, std::uint64_t{deed.of} * 2 + deed.value);
      plant_.set_quality(deed.of, deed.value != 0);
      return;
    }
    using By = engine::MalfunctionChange::By;
    const By by = replay_.by_hand[deed.of] ? By::hand : By::scenario;
    const scenario::Step& step = replay_.acts.steps[deed.of];
    notes.act(now, trace::kActNote, deed.of);
    scenario::write_symbols(step, plant_, nullptr);
    for (const scenario::NewPart& part : step.put) plant_.put(part.at, part.kind);
    for (const tables::PartLocation& from : step.take) plant_.take(from);
    scenario::force_symbols(step, plant_, notes);
    for (const std::uint32_t malfunction : step.stop) plant_.stop_malfunction(malfunction, by);
    for (const std::uint32_t malfunction : step.start) plant_.start_malfunction(malfunction, by);
  }

  Stage& stage_;
  plant::Plant& plant_;
  const Replay& replay_;
  const std::vector<std::uint32_t> flickering_;
  std::vector<bool> shown_;  ///< by operation of flickering_: as the trace has it
  trace::Recorder unseen_;   ///< gets the notes of what is only tried
  std::size_t at_ = 0;
};

}  // namespace

void run_replay(Stage& stage, const Replay& replay, const RunOptions& options, std::ostream& out) {
  const tables::Time until = options.until.value_or(tables::kNever);
  const tables::Time end = std::min(replay.end, until);
  stage.outputs.write_acts([&replay](std::uint64_t act) {
    return ActText{replay.texts[act], replay.by_hand[act] ? "hand" : "scenario"};
  });
  Replayer replayer(stage, replay);
  bool going = true;
  while (going && !replayer.over() && replayer.next() <= end) {
    going = replayer.go_before(replayer.next());
    if (going) replayer.next_instant();
  }
  if (going && replayer.go_before(end)) {
    replayer.run_to(end);
    out << fmt::format("ended at {}: {}\n", trace::seconds(stage.plant.now()),
                       until < replay.end ? "--until is reached" : "the trace ends");
    return;
  }
  out << fmt::format("ended at {} by a signal\n", trace::seconds(stage.plant.now()));
}

bool replay_fits(const RunOptions& options, std::ostream& err) {
  using enum RunOptions::Clock;
  const std::pair<const char*, bool> contrary[] = {
      {"--scenario", !options.scenario.empty()},    {"--link", !options.links.empty()},
      {"--program", !options.programs.empty()},     {"--panel", options.panel.has_value()},
      {"--exercise", !options.exercises.empty()},   {"--resume", !options.resume.empty()},
      {"--rt-check", options.rt_check.has_value()}, {"--clock", options.clock == real_time || options.clock == plc}};
  for (const auto& [name, given] : contrary) {
    if (options.replay.empty() || !given) continue;
    err << "error: `--replay` repeats what a trace has, in virtual time: remove `" << name << "`\n";
    return false;
  }
  return true;
}

RunOptions options_of_replay(RunOptions options, const Replay& replay) {
  options.clock = RunOptions::Clock::virtual_time;
  if (!options.seed_given) options.seed = replay.seed;
  return options;
}

void report_other_run(const Stage& stage, const RunOptions& options, const Replay& replay, std::ostream& err) {
  if (fmt::format("{:016x}", stage.plant.model_hash()) != replay.model_hash) {
    err << "warning: `" << options.replay << "` is of another model: the replay goes as far as this one fits\n";
  }
  if (options.seed != replay.seed) {
    err << "warning: `" << options.replay << "` was recorded with `--seed " << replay.seed
        << "`: with another one random times differ\n";
  }
}

}  // namespace symplant::host

// Repeats a recorded run from its trace, in virtual time.
#include "symplant/host/run_replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "symplant/host/signals.hpp"
#include "symplant/scenario/act.hpp"
#include "symplant/tables/malfunction_numbers.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::host {
namespace {

using Deed = Replay::Deed;

class Replayer {
 public:
  Replayer(Stage& stage, const Replay& replay) : stage_(stage), plant_(stage.plant), replay_(replay) {}

  /// A trace has a line for each bit that is 1 at the start. An operation without one is 0, whatever it is by itself.
  void begin() {
    const auto symbols = plant_.tables().symbols;
    std::vector<bool> has_line(symbols.size(), false);
    for (const Deed& deed : replay_.deeds) {
      if (deed.time > 0 || deed.instant > 1) break;
      if (deed.kind == Deed::Kind::operation) has_line[deed.of] = true;
    }
    for (std::uint32_t symbol = 0; symbol < symbols.size(); ++symbol) {
      const tables::SymbolRow& row = symbols[symbol];
      if (row.direction() != tables::Direction::operation || row.type() != tables::DataType::boolean) continue;
      if (has_line[symbol]) continue;
      write({0, 1, 0, symbol, Deed::Kind::operation});
    }
  }

  bool over() const { return at_ == replay_.deeds.size(); }
  tables::Time next() const { return replay_.deeds[at_].time; }

  /// Runs the instants before `time`, one by one, so that their records have room; false if a signal came.
  bool go_before(tables::Time time) {
    for (tables::Time due = plant_.next_due(); due < time; due = plant_.next_due()) {
      if (stop_requested().load(std::memory_order_relaxed)) return false;
      run(due);
    }
    plant_.advance_before(time, &stage_.recorder);
    return true;
  }

  void run(tables::Time time) {
    plant_.advance_to(time, &stage_.recorder);
    stage_.outputs.drain();
  }

  /// Runs the next instant with something from outside, after those of its time that come before.
  void next_instant() {
    const Deed first = replay_.deeds[at_];
    uncover(first.time);
    for (std::uint64_t ran = stage_.recorder.instants_at(first.time); ran + 1 < first.instant;) {
      run(first.time);
      const std::uint64_t now = stage_.recorder.instants_at(first.time);
      if (now == ran) break;  // of another model: there are not as many
      ran = now;
    }
    const std::size_t begin = at_;
    while (!over() && next() == first.time && replay_.deeds[at_].instant == first.instant) ++at_;
    for (std::size_t i = begin; i < at_; ++i) {
      if (replay_.deeds[i].kind != Deed::Kind::operation) act(replay_.deeds[i]);
    }
    for (std::size_t i = begin; i < at_; ++i) {
      if (replay_.deeds[i].kind == Deed::Kind::operation) write(replay_.deeds[i]);
    }
    run(first.time);
  }

 private:
  /// A trace has what operations show. What was written to one that is held, by a force or a malfunction, shows when
  /// that ends, and a malfunction may end within an earlier instant of this time than the one that shows it.
  void uncover(tables::Time time) {
    for (std::size_t i = at_; i < replay_.deeds.size() && replay_.deeds[i].time == time; ++i) {
      const Deed& deed = replay_.deeds[i];
      if (deed.kind != Deed::Kind::operation) return;
      if (plant_.malfunction_of_symbol(deed.of) != tables::kNone) write(deed);
    }
  }

  void write(const Deed& deed) {
    const tables::SymbolRow& row = plant_.tables().symbols[deed.of];
    if (row.type() == tables::DataType::boolean) {
      plant_.set_operation(row.index, deed.value != 0);
    } else {
      plant_.set_operation_value(row.index, deed.value);
    }
  }

  void act(const Deed& deed) {
    const tables::Time now = plant_.now();
    stage_.recorder.begin_act(now);
    if (deed.kind == Deed::Kind::quality) {
      stage_.recorder.act(now, trace::kQualityNote, std::uint64_t{deed.of} * 2 + deed.value);
      plant_.set_quality(deed.of, deed.value != 0);
      return;
    }
    using By = engine::MalfunctionChange::By;
    const By by = replay_.by_hand[deed.of] ? By::hand : By::scenario;
    const scenario::Step& step = replay_.acts.steps[deed.of];
    stage_.recorder.act(now, trace::kActNote, deed.of);
    scenario::write_symbols(step, plant_, nullptr);
    for (const scenario::NewPart& part : step.put) plant_.put(part.at, part.kind);
    for (const tables::PartLocation& from : step.take) plant_.take(from);
    scenario::force_symbols(step, plant_, stage_.recorder);
    for (const std::uint32_t malfunction : step.stop) plant_.stop_malfunction(malfunction, by);
    for (const std::uint32_t malfunction : step.start) plant_.start_malfunction(malfunction, by);
  }

  Stage& stage_;
  plant::Plant& plant_;
  const Replay& replay_;
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
  replayer.begin();
  bool going = true;
  while (going && !replayer.over() && replayer.next() <= end) {
    going = replayer.go_before(replayer.next());
    if (going) replayer.next_instant();
  }
  if (going && replayer.go_before(end)) {
    replayer.run(end);
    out << fmt::format("ended at {}: {}\n", trace::seconds(stage.plant.now()),
                       until < replay.end ? "--until is reached" : "the trace ends");
    return;
  }
  out << fmt::format("ended at {} by a signal\n", trace::seconds(stage.plant.now()));
}

bool replay_fits(const RunOptions& options, std::ostream& err) {
  using enum RunOptions::Clock;
  const std::pair<const char*, bool> contrary[] = {{"--scenario", !options.scenario.empty()},
                                                   {"--fault", !options.fault.empty()},
                                                   {"--link", !options.links.empty()},
                                                   {"--program", !options.programs.empty()},
                                                   {"--panel", options.panel.has_value()},
                                                   {"--exercise", !options.exercises.empty()},
                                                   {"--resume", !options.resume.empty()},
                                                   {"--rt-check", options.rt_check.has_value()},
                                                   {"--clock", options.clock == real_time || options.clock == plc}};
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
    err << "warning: `" << options.replay
        << "` is of another model: with the same operations this plant may behave differently\n";
  }
  if (options.seed != replay.seed) {
    err << "warning: `" << options.replay << "` was recorded with `--seed " << replay.seed
        << "`: with another one random times differ\n";
  }
  const tables::PlantTables& tables = stage.plant.tables();
  const tables::MalfunctionNumbers numbers(tables);
  const auto hides_operation = [&](std::uint32_t malfunction) {
    bool hides = false;
    numbers.for_symbols(malfunction, [&](std::uint32_t symbol) {
      hides = hides || tables.symbols[symbol].direction() == tables::Direction::operation;
    });
    return hides;
  };
  std::uint32_t hiding = 0;
  while (hiding < tables.malfunctions.size() && !hides_operation(hiding)) ++hiding;
  if (hiding == tables.malfunctions.size()) return;
  err << "warning: malfunction `" << tables::split_names(tables.malfunctions.names)[hiding]
      << "` changes an operation: the trace has the changed value, not the one that was written, so the replay may "
         "differ "
         "there\n";
}

}  // namespace symplant::host

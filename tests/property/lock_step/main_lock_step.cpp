// Random plants with random PLC programs in lock step: engine and reference must agree.
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "lower/lower.hpp"
#include "property/behaviours.hpp"
#include "property/differences.hpp"
#include "property/lock_step/engine_programs.hpp"
#include "property/malfunction_names.hpp"
#include "property/options.hpp"
#include "property/random_malfunctions.hpp"
#include "property/random_plant.hpp"
#include "support/reference/programs.hpp"

namespace symplant::property {
namespace {

struct Counts {
  long plants = 0;
  long with_several = 0;
  long scans = 0;
  long samples = 0;
  long restarts = 0;
  long losses = 0;
  long zeroed = 0;
  long cut_short = 0;
};

reference::Program reference_program(const ProgramTable& table) {
  reference::Program program{.controller = table.controller,
                             .period = table.period,
                             .delay = table.delay,
                             .zero_on_loss = table.zero_on_loss,
                             .reads = table.reads,
                             .writes = table.writes};
  program.start = [&table] {
    return [&table, memory = ProgramMemory(table)](const auto& in, auto& out, tables::Time now) mutable {
      react(table, memory, in, out, now);
    };
  };
  return program;
}

/// One plant, with its programs in engine and reference.
class LockStepRun {
 public:
  LockStepRun(std::uint64_t seed, const model::PlantModel& model, const tables::PlantTables& tables, Counts& counts)
      : dice_(seed * 2 + 0x10C'5735'0000),
        model_(model),
        counts_(counts),
        engine_(tables, engine_behaviours(tables)),
        reference_(model, reference_behaviours(tables)),
        programs_(random_programs(dice_, model, tables)),
        engine_programs_(programs_, model),
        engine_steps_(engine_.plant(), &engine_.observer()) {
    reset();
    std::vector<reference::Program> rows;
    for (const ProgramTable& table : programs_) rows.push_back(reference_program(table));
    reference_steps_ = std::make_unique<reference::LockStep>(model, reference_, std::move(rows));
    ++counts.plants;
    if (programs_.size() > 1) ++counts.with_several;
  }

  /// The first difference; empty if there is none.
  std::string play() {
    if (const std::string error = engine_programs_.add_to(engine_steps_, dice_.percent(50)); !error.empty())
      return error;
    tables::Time time = 0;
    std::string text = advance(time);
    for (int i = 0; i < kAdvances && text.empty() && !cut_; ++i) {
      if (dice_.percent(35)) {
        act();
        text = advance(time);
        if (!text.empty() || cut_) break;
      }
      time += 1 + static_cast<tables::Time>(dice_.below(dice_.percent(80) ? 60 : 2'000) * tables::kMillisecond);
      text = advance(time);
    }
    counts_.scans += reference_steps_->scans;
    counts_.samples += reference_steps_->samples;
    counts_.losses += reference_steps_->losses;
    counts_.zeroed += reference_steps_->zeroed;
    return text;
  }

 private:
  static constexpr int kAdvances = 25;
  static constexpr int kMostInstants = 1500;  // some plants have one every nanosecond

  void reset() {
    const std::uint64_t seed = dice_.below(4);
    engine_.plant().reset(seed, 0);
    reference_.reset(seed, 0);
  }

  std::string advance(tables::Time time) {
    engine_.forget();
    reference_.clear_instants();
    if (!reference_steps_->advance_to(time, kMostInstants)) {
      cut_ = true;
      ++counts_.cut_short;
      return {};
    }
    engine_steps_.advance_to(time);
    const std::string text = instants_difference(engine_, reference_, model_);
    return text.empty() ? state_difference(engine_, reference_, model_) : text;
  }

  /// What happens from outside, in both.
  void act() {
    using By = engine::MalfunctionChange::By;
    const std::size_t kind = dice_.below(10);
    if (kind < 2) {
      const auto controller = static_cast<std::uint32_t>(dice_.below(model_.controllers.size()));
      engine_steps_.restart(controller);
      reference_steps_->restart(controller);
      ++counts_.restarts;
    } else if (kind < 6) {
      const auto malfunction = malfunction_number(model_, random_malfunction(dice_, model_));
      if (!malfunction) return;
      const bool start = dice_.percent(65);
      const auto change = [&](auto& plant) {
        start ? plant.start_malfunction(*malfunction, By::hand) : plant.stop_malfunction(*malfunction, By::hand);
      };
      change(engine_.plant());
      change(reference_);
    } else if (!model_.symbols.empty()) {
      const auto symbol = static_cast<std::uint32_t>(dice_.below(model_.symbols.size()));
      const std::uint64_t value = random_content(dice_, model_.symbols[symbol].type);
      const bool force = dice_.percent(40);
      const auto change = [&](auto& plant) {
        if (kind < 8) {
          plant.set_input(symbol, value);
        } else if (force) {
          plant.force(symbol, value);
        } else {
          plant.release(symbol);
        }
      };
      change(engine_.plant());
      change(reference_);
    }
  }

  Dice dice_;
  const model::PlantModel& model_;
  Counts& counts_;
  EnginePlant engine_;
  reference::Plant reference_;
  const std::vector<ProgramTable> programs_;
  const EnginePrograms engine_programs_;
  program::LockStep engine_steps_;
  std::unique_ptr<reference::LockStep> reference_steps_;
  bool cut_ = false;
};

int run(const Options& options) {
  Counts counts;
  for (std::uint64_t seed = options.seed; seed < options.seed + options.plants; ++seed) {
    const DrawnPlant drawn = random_plant(seed, {.most_units = 60});
    const lower::EngineTables tables = lower::lower(drawn.model);
    const tables::PlantTables rows = tables.tables();
    const std::string text = LockStepRun(seed, drawn.model, rows, counts).play();
    if (text.empty()) continue;
    std::cout << "plant " << seed << " disagrees: " << text << "\n";
    return options.wrong ? 0 : 1;
  }
  if (options.wrong) {
    std::cout << "no plant disagrees\n";
    return 1;
  }
  const std::pair<const char*, long> rows[] = {
      {"plants", counts.plants},        {"with several programs", counts.with_several},
      {"scans", counts.scans},          {"operations changed by scans", counts.samples},
      {"restarts", counts.restarts},    {"losses of a controller", counts.losses},
      {"losses to zero", counts.zeroed}};
  bool missed = false;
  for (const auto& [what, count] : rows) {
    if (!options.quiet) std::cout << count << "  " << what << "\n";
    if (count < options.minimum) std::cout << "only " << count << " times: " << what << "\n";
    missed = missed || count < options.minimum;
  }
  if (!options.quiet) std::cout << counts.cut_short << "  plants cut short\n";
  return missed ? 1 : 0;
}

}  // namespace
}  // namespace symplant::property

int main(int argc, char** argv) {
  const auto options = symplant::property::read_options({argv + 1, argv + argc});
  return options ? symplant::property::run(*options) : 2;
}

// Runs a plant in step with the clock, at the speed that its panel asks for.
#include "symplant/host/run_paced.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ostream>
#include <thread>

#include "symplant/host/signals.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::host {
namespace {

using Clock = std::chrono::steady_clock;
using trace::seconds;

/// With an unlimited speed: of a cycle, the part in which the plant runs. The rest is for other threads.
constexpr double kBusy = 0.9;
constexpr tables::Time kLatest = tables::kNever / 2;

class PacedRun {
 public:
  PacedRun(Stage& stage, const RunOptions& options, panel::Panel& panel)
      : stage_(stage),
        panel_(panel),
        stepper_(*stage.stepper(&panel.stepper())),
        cycle_(options.cycle),
        until_(options.until.value_or(tables::kNever)) {}

  void all() {
    Clock::time_point next = Clock::now();
    while (!stop_requested().load(std::memory_order_relaxed) && now() < until_ && !stepper_.failed()) {
      next = std::max(next + std::chrono::nanoseconds(cycle_), Clock::now());
      std::this_thread::sleep_until(next);
      if (stepper_.frozen()) {
        stepper_.hold();
        stage_.outputs.drain();
      } else {
        one(next);
      }
      stage_.outputs.flush_when_due();
    }
  }

 private:
  tables::Time now() const { return stage_.plant.now(); }

  /// One cycle: instant by instant, so that the records of any number of them have room.
  void one(Clock::time_point begin) {
    const auto busy = static_cast<tables::Time>(kBusy * static_cast<double>(cycle_));
    const Clock::time_point end = begin + std::chrono::nanoseconds(busy);
    if (panel_.stepping() == panel::Stepping::cycle) return step_to(std::min(now() + cycle_, until_));
    const bool at_once = panel_.stepping() == panel::Stepping::change || panel_.speed() == 0;
    const tables::Time target = std::min(at_once && due() != tables::kNever ? until_ : now() + length(), until_);
    do {
      const tables::Time before = now();
      step_to(std::clamp(due(), before, std::min(target, kLatest)));
      if (now() < before || stepper_.frozen()) return;  // it was set back, or this was a step
    } while (now() < target && due() != tables::kNever && Clock::now() < end);
  }

  tables::Time due() const {
    const tables::Time due = std::min(stage_.plant.next_due(), panel_.next_step());
    return stage_.programs ? std::min(due, stage_.programs->next_due()) : due;
  }

  /// The plant time of a cycle.
  tables::Time length() const {
    const double speed = panel_.speed();
    return std::max<tables::Time>(static_cast<tables::Time>(static_cast<double>(cycle_) * (speed == 0 ? 1 : speed)), 1);
  }

  void step_to(tables::Time time) {
    stepper_.advance_to(time);
    stage_.outputs.drain();
  }

  Stage& stage_;
  panel::Panel& panel_;
  exec::Stepper& stepper_;
  tables::Time cycle_;
  tables::Time until_;
};

}  // namespace

void run_paced(Stage& stage, const RunOptions& options, panel::Panel& panel, std::ostream& out) {
  PacedRun(stage, options, panel).all();
  out << fmt::format("ended at {}{}\n", seconds(stage.plant.now()),
                     stop_requested().load() ? " by a signal" : ": --until is reached");
}

}  // namespace symplant::host

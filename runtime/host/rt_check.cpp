// --rt-check: runs cycles of the plant under the real-time guard.
#include "symplant/host/rt_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "symplant/exec/cycle.hpp"
#include "symplant/exec/real_time.hpp"
#include "symplant/exec/rt_check.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/host/watched_link.hpp"
#include "symplant/host/words.hpp"

namespace symplant::host {
namespace {

/// Jumps to each time that is waited for.
class VirtualClock final : public exec::Clock {
 public:
  explicit VirtualClock(tables::Time now) : now_(now) {}
  tables::Time now() noexcept override { return now_; }
  void sleep_until(tables::Time time) noexcept override { now_ = std::max(now_, time); }

 private:
  tables::Time now_;
};

/// Advances the stage and drains its records, since no other thread drains them.
class DrainingStage final : public exec::Stepper {
 public:
  explicit DrainingStage(Stage& stage) : stage_(stage) {}

  void advance_to(tables::Time time) noexcept override {
    stage_.advance_to(time);
    const exec::Unguarded draining;
    const exec::ThreadFaults before = exec::thread_faults();
    stage_.outputs.drain();
    drained_ += exec::thread_faults() - before;
  }
  bool over() const noexcept override { return false; }
  /// Page faults and preemptions caused by draining.
  const exec::ThreadFaults& drained() const noexcept { return drained_; }

 private:
  Stage& stage_;
  exec::ThreadFaults drained_;
};

}  // namespace

tables::Time end_of_rt_check(tables::Time begin, const RunOptions& options) {
  const auto most = static_cast<std::uint64_t>((tables::kNever - begin) / options.cycle);
  const auto count = static_cast<tables::Time>(std::min(*options.rt_check, most - 1));
  return begin + count * options.cycle;
}

bool report_missing_cycles(std::uint64_t cycles, const RunOptions& options, std::ostream& out) {
  const std::uint64_t asked = options.rt_check.value_or(0);
  if (cycles >= asked) return false;
  out << fmt::format("rt-check: {} of {} cycles were not checked, since a signal ended the run\n", asked - cycles,
                     asked);
  return true;
}

bool report_rt_check(const exec::GuardReport& report, const exec::ThreadFaults& faults, std::uint64_t cycles,
                     const Stage& stage, std::ostream& out) {
  for (const std::string& line : exec::rt_check_lines(report, stage.plant.tables())) {
    out << "rt-check: " << shown(line) << "\n";
  }
  if (faults.pages() != 0) {
    out << fmt::format("rt-check: memory: {} ({} from disk): the cycle used memory that was not in RAM\n",
                       plural(faults.pages(), "page fault"), faults.major);
  }
  const std::uint64_t acts = report.count + faults.pages();
  out << fmt::format("rt-check: {} cycles, {}\n", cycles,
                     acts == 0 ? "nothing found" : plural(acts, "action") + " that a cycle must not take");
  return acts == 0;
}

bool run_rt_check(Stage& stage, const RunOptions& options, const Links& links, std::ostream& out) {
  const WatchedLinks watched(links, stage.plant, stage.recorder);
  const tables::Time begin = stage.plant.now();
  const exec::CycleOptions cycle{.cycle = options.cycle, .until = end_of_rt_check(begin, options)};
  out << fmt::format("rt-check: {} cycles of {} ms under the guard\n", *options.rt_check,
                     static_cast<double>(cycle.cycle) / 1e6);
  out.flush();

  VirtualClock clock(begin);
  const auto meter = std::make_unique<exec::CycleMeter>();
  DrainingStage draining(stage);
  exec::ThreadFaults faults;
  const exec::GuardReport report = exec::run_watched([&] {
    exec::set_up_real_time({});
    const exec::ThreadFaults before = exec::thread_faults();
    exec::run_cycles(stage.plant, watched.exchanges(), cycle,
                     {.clock = clock, .meter = *meter, .stop = stop_requested(), .stepper = &draining});
    faults = exec::thread_faults() - before - draining.drained();
  });
  const std::uint64_t cycles = meter->cycles.value();
  const bool clean = report_rt_check(report, faults, cycles, stage, out);
  return !report_missing_cycles(cycles, options, out) && clean;
}

}  // namespace symplant::host

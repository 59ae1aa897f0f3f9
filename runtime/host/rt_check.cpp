// Cycles of the plant under the guard of real time.
#include "symplant/host/rt_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "symplant/exec/guard/guard.hpp"
#include "symplant/exec/rt_check.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/host/watched_link.hpp"
#include "symplant/host/words.hpp"

namespace symplant::host {
namespace {

/// Goes as fast as it is waited for.
class VirtualClock final : public exec::Clock {
 public:
  explicit VirtualClock(core::Time now) : now_(now) {}
  core::Time now() noexcept override { return now_; }
  void sleep_until(core::Time time) noexcept override { now_ = std::max(now_, time); }

 private:
  core::Time now_;
};

/// Advances the stage inside the guard.
class GuardedStage final : public exec::Stepper {
 public:
  GuardedStage(Stage& stage, bool drains) : stage_(stage), drains_(drains) {}

  void advance_to(core::Time time) noexcept override {
    {
      const exec::Guard guard;
      stage_.advance_to(time);
    }
    if (drains_) stage_.outputs.drain();
  }
  bool over() const noexcept override { return false; }

 private:
  Stage& stage_;
  bool drains_;  ///< what was recorded, since no thread does
};

}  // namespace

RtChecked run_rt_check(Stage& stage, const RunOptions& options, const Links& links, bool real, std::ostream& out) {
  const WatchedLinks watched(links, stage.plant.tables(), stage.recorder);
  const core::Time begin = stage.plant.now();
  exec::CycleOptions cycle;
  cycle.cycle = options.cycle;
  const std::uint64_t most = static_cast<std::uint64_t>(core::kNever - begin) / static_cast<std::uint64_t>(cycle.cycle);
  const auto count = static_cast<core::Time>(std::min(*options.rt_check, most - 1));
  cycle.until = std::min(begin + count * cycle.cycle, options.until.value_or(core::kNever));
  out << fmt::format("rt-check: {} cycles of {} ms under the guard\n", count, static_cast<double>(cycle.cycle) / 1e6);
  out.flush();

  exec::MonotonicClock monotonic;
  VirtualClock fast(begin);
  exec::Clock& clock = real ? static_cast<exec::Clock&>(monotonic) : fast;
  GuardedStage guarded(stage, !real);
  RtChecked checked{};
  if (real) stage.outputs.start_thread();
  const exec::GuardReport report = exec::run_watched([&] {
    checked.cycles =
        exec::run_cycles(stage.plant, watched.exchanges(), cycle, clock, nullptr, stop_requested(), &guarded);
  });
  if (real) stage.outputs.stop_thread();

  checked.clean = report.count == 0;
  for (const std::string& line : exec::rt_check_lines(report, stage.plant.tables())) {
    out << "rt-check: " << shown(line) << "\n";
  }
  out << fmt::format("rt-check: {} cycles, {}\n", checked.cycles.cycles,
                     checked.clean ? "nothing found" : plural(report.count, "act") + " that a cycle must not do");
  return checked;
}

}  // namespace symplant::host

// A run in real time, beside a PLC.
#include "symplant/host/run_real.hpp"

#include <fmt/format.h>

#include <vector>

#include "symplant/host/signals.hpp"
#include "symplant/host/watched_link.hpp"
#include "symplant/host/words.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::host {

using trace::seconds;

namespace {

/// What happens when the link's PLC is silent, said before anything runs.
std::string policy_words(const OpenLink& open) {
  if (open.link->state() != exec::LinkState::waiting) return "";
  const link::LinkSettings& settings = open.settings;
  const bool watchdog = settings.watchdog != link::kNowhere;
  return fmt::format("; after {} {}: operations {}, the plant {}",
                     seconds(watchdog ? settings.watchdog_within : settings.loss_after),
                     watchdog ? "without a change of the watchdog" : "of silence",
                     settings.on_loss == link::OnLoss::zero ? "go to zero" : "hold",
                     settings.plant_on_loss == link::PlantOnLoss::freeze ? "stands still" : "runs on");
}

}  // namespace

exec::CycleStatistics run_real(Stage& stage, const RunOptions& options, const Links& links, std::ostream& out) {
  const WatchedLinks watched(links, stage.plant.tables(), stage.recorder);
  for (const OpenLink& open : links) out << fmt::format("link {}{}\n", open.text(), policy_words(open));
  out << fmt::format("running in real time, a cycle of {} ms{}\n", static_cast<double>(options.cycle) / 1e6,
                     options.until  ? fmt::format(", until {}", seconds(*options.until))
                     : stage.player ? ", until the scenario is over"
                                    : "; Ctrl-C ends it");
  out.flush();
  stage.outputs.start_thread();
  exec::MonotonicClock clock;
  exec::CycleOptions cycle;
  cycle.cycle = options.cycle;
  cycle.until = options.until.value_or(core::kNever);
  const exec::CycleStatistics done = exec::run_cycles(stage.plant, watched.exchanges(), cycle, clock, &stage.recorder,
                                                      stop_requested(), stage.player ? &*stage.player : nullptr);
  stage.outputs.stop_thread();

  out << fmt::format("ended at {}{}: {} cycles, {} overruns, {} lost, latest start {} us late\n",
                     seconds(stage.plant.now()), stop_requested().load() ? " by a signal" : "", done.cycles,
                     done.overruns, seconds(done.slipped), done.max_lateness / 1000);
  for (const OpenLink& open : links) {
    const link::LinkStatus status = open.link->status();
    out << fmt::format("link {}: {} requests, {} exceptions, {} writes to gaps, lost {}\n", open.text(),
                       status.requests, status.exceptions, status.writes_to_gaps, plural(status.losses, "time"));
  }
  return done;
}

}  // namespace symplant::host

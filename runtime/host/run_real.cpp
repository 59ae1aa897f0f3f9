// A run in real time, beside a PLC.
#include "symplant/host/run_real.hpp"

#include <fmt/format.h>

#include <vector>

#include "symplant/host/signals.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::host {

using trace::seconds;

exec::CycleStatistics run_real(Stage& stage, const RunOptions& options, const Links& links, std::ostream& out) {
  std::vector<exec::Exchange*> exchanges;
  for (const OpenLink& open : links) {
    exchanges.push_back(open.link.get());
    out << fmt::format("link {}\n", open.text());
  }
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
  const exec::CycleStatistics done = exec::run_cycles(stage.plant, exchanges, cycle, clock, &stage.recorder,
                                                      stop_requested(), stage.player ? &*stage.player : nullptr);
  stage.outputs.stop_thread();

  out << fmt::format("ended at {}{}: {} cycles, {} overruns, {} lost, latest start {} us late\n",
                     seconds(stage.plant.now()), stop_requested().load() ? " by a signal" : "", done.cycles,
                     done.overruns, seconds(done.slipped), done.max_lateness / 1000);
  for (const OpenLink& open : links) {
    const link::LinkStatus status = open.link->status();
    out << fmt::format("link {}: {} requests, {} exceptions, {} writes to gaps\n", open.text(), status.requests,
                       status.exceptions, status.writes_to_gaps);
  }
  return done;
}

}  // namespace symplant::host

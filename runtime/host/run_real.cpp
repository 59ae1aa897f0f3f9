// Runs a plant in real time, against a PLC.
#include "symplant/host/run_real.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "symplant/exec/cycle.hpp"
#include "symplant/host/attendant.hpp"
#include "symplant/host/cycle_thread.hpp"
#include "symplant/host/link_commands.hpp"
#include "symplant/host/panel_run.hpp"
#include "symplant/host/rt_check.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/host/waits.hpp"
#include "symplant/host/watched_link.hpp"
#include "symplant/host/words.hpp"
#include "symplant/link/link_map.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::host {
namespace {

using trace::seconds;

/// "hold": what the operations of a link do while it is lost.
std::string operations_on_loss(const OpenLink& open, const tables::PlantTables& tables) {
  const auto map = link::map_of(open.choice, tables);
  const auto* const good = std::get_if<link::LinkMap>(&map);
  return good == nullptr ? "" : link::loss_words(tables, *good);
}

/// The policy of a link on loss, for the report at the start.
std::string policy_words(const OpenLink& open, const tables::PlantTables& tables) {
  if (open.link->state() != exec::LinkState::waiting) return "";
  const link::LinkSettings& settings = open.choice.settings;
  const bool watchdog = settings.watchdog != link::kNowhere;
  return fmt::format(
      "; after {} {}: operations {}, the plant {}", seconds(watchdog ? settings.watchdog_within : settings.loss_after),
      watchdog                        ? "without a change of the watchdog"
      : open.link->status().is_client ? "without an answer"
                                      : "without a request",
      operations_on_loss(open, tables), settings.plant_on_loss == link::PlantOnLoss::freeze ? "freezes" : "runs on");
}

/// Warns of links whose timeouts are too short for the cycle.
void warn_of_times(const RunOptions& options, const Links& links, std::ostream& err) {
  for (const OpenLink& open : links) {
    const link::LinkSettings& settings = open.choice.settings;
    if (open.link->state() != exec::LinkState::waiting) continue;
    const bool watchdog = settings.watchdog != link::kNowhere;
    const tables::Time silence = watchdog ? settings.watchdog_within : settings.loss_after;
    if (silence > 2 * options.cycle) continue;
    err << fmt::format(
        "warning: link {}: `{}` of {} is not longer than two cycles of {}: the link will be lost repeatedly; give a "
        "longer time\n",
        open.text(), watchdog ? "within" : "loss-after", seconds(silence), seconds(options.cycle));
  }
}

void report_begin(const Stage& stage, const RunOptions& options, const Links& links, const PlcClockChoice* clock,
                  std::ostream& out) {
  for (const OpenLink& open : links) {
    out << fmt::format("link {}{}\n", open.text(), policy_words(open, stage.plant.tables()));
  }
  const std::string cycle = fmt::format("a cycle of {} ms", static_cast<double>(options.cycle) / 1e6);
  if (options.rt_check) {
    out << fmt::format("rt-check: {} cycles in real time under the guard, {}\n", *options.rt_check, cycle);
  } else {
    out << fmt::format("running in real time, {}{}{}\n", cycle,
                       clock != nullptr ? ", plant time from " + clock->text() : "",
                       options.until  ? fmt::format(", until {}", seconds(*options.until))
                       : stage.player ? ", until the scenario is over"
                                      : "; Ctrl-C ends it");
  }
  out.flush();
}

std::string text_of(const char* what, const exec::Durations& durations) {
  const auto us = [](tables::Time time) { return static_cast<double>(time) / 1e3; };
  return fmt::format("{}: p50 {:.1f} us, p99 {:.1f} us, p99.9 {:.1f} us, max {:.1f} us\n", what, us(durations.p50),
                     us(durations.p99), us(durations.p999), us(durations.max));
}

std::string end_words(const link::LinkStatus& status) {
  if (status.is_client) {
    return fmt::format("{} requests, {} rejected, {}, lost {}", status.requests, status.exceptions,
                       status.armed ? "armed" : "not armed: wrote nothing", plural(status.losses, "time"));
  }
  const std::string answered =
      status.has_nodes ? fmt::format("{} requests, {} writes and calls refused", status.requests, status.exceptions)
                       : fmt::format("{} requests, {} exceptions, {} writes to gaps", status.requests,
                                     status.exceptions, status.writes_to_gaps);
  return fmt::format("{}, lost {}{}", answered, plural(status.losses, "time"),
                     status.crowded_out == 0
                         ? ""
                         : fmt::format(", {} {} for lack of room: set more `connections`{} in plant.json",
                                       plural(status.crowded_out, "client"), status.has_nodes ? "refused" : "closed",
                                       status.has_nodes ? "" : ", or `keep`,"));
}

std::string text_of(const exec::PlcClockReading& clock) {
  const auto ms = [](tables::Time time) { return static_cast<double>(time) / 1e6; };
  return fmt::format("the PLC's clock: {}, phase error {:.1f} ms, at most {:.1f} ms, {}, {}\n",
                     plural(clock.values, "value"), ms(clock.phase_error), ms(clock.largest_phase_error),
                     plural(clock.waits, "wait"), plural(clock.restarts, "restart"));
}

/// The links, as the user is to read of them during the run.
Waits waits_of(const Stage& stage, const Links& links, const PlcClockChoice* clock) {
  std::vector<WaitedLink> waited;
  for (std::uint32_t i = 0; i < links.size(); ++i) {
    const bool ignored = stage.report.is_ignored({0, tables::FindingKind::no_plc, {i}});
    waited.push_back({"link " + links[i].text(), ignored ? "" : links[i].absence(),
                      links[i].choice.settings.plant_on_loss == link::PlantOnLoss::freeze,
                      clock != nullptr && clock->link == i});
  }
  return {std::move(waited), clock != nullptr ? clock->name : ""};
}

void report_end(const Stage& stage, const RealRun& run, const Links& links, std::ostream& out) {
  const exec::CycleStatistics& cycles = run.cycles;
  out << fmt::format("ended at {}{}: {} cycles, {} overruns, {} slipped{}\n", seconds(stage.plant.now()),
                     stop_requested().load() ? " by a signal" : "", cycles.cycles, cycles.overruns,
                     seconds(cycles.slipped),
                     cycles.frozen == 0 ? "" : fmt::format(", frozen for {}", seconds(cycles.frozen)));
  if (cycles.cycles != 0) {
    out << text_of("cycles late by", cycles.lateness) << text_of("work of a cycle", cycles.work)
        << text_of("jitter of the cycle", cycles.jitter)
        << fmt::format("the cycle's thread: {} page faults ({} from disk), preempted {} times\n", run.faults.pages(),
                       run.faults.major, run.faults.preempted);
  }
  if (cycles.plc_clock) out << text_of(*cycles.plc_clock);
  for (const OpenLink& open : links) {
    out << fmt::format("link {}: {}\n", open.text(), end_words(open.link->status()));
  }
}

/// Reports a standstill of the plant as a finding.
class ReportedStandstill final : public exec::StandstillWatch {
 public:
  ReportedStandstill(const plant::Plant& plant, trace::Recorder& recorder) : plant_(plant), recorder_(recorder) {}

  void stood_still(tables::Time lost) noexcept override {
    const auto ms = static_cast<std::uint32_t>(std::min<tables::Time>(lost / tables::kMillisecond, 0xFFFF'FFFE));
    recorder_.raise(plant_.now(), tables::FindingKind::standstill, ms);
  }

 private:
  const plant::Plant& plant_;
  trace::Recorder& recorder_;
};

/// Waits until a PLC that reads the status block has read that the plant stops, for at most 0.5 s.
void let_end_be_read(const Links& links) {
  constexpr int kEndLooks = 100;  // 0.5 s: SIGTERM is to end a run within 1 s
  const auto unread = [](const OpenLink& open) { return open.link->status().end_unread; };
  for (int i = 0; i < kEndLooks && std::any_of(links.begin(), links.end(), unread); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}  // namespace

RealRun run_real(Stage& stage, const RunOptions& options, const Links& links, const PlcClockChoice* clock,
                 panel::Panel* panel, const RunStreams& streams) {
  std::ostream& out = streams.report;
  std::ostream& err = streams.err;
  const WatchedLinks watched(links, stage.plant, stage.recorder);
  exec::CycleOptions cycle{.cycle = options.cycle,
                           .until = options.until.value_or(tables::kNever),
                           .max_catch_up = options.max_catch_up,
                           .spin = options.spin};
  if (stage.player && options.limit && !options.until) {
    cycle.until = *options.limit;
    cycle.ends_when_over = true;
  }
  if (options.rt_check) cycle.until = end_of_rt_check(stage.plant.now(), options);

  std::optional<ReportedPlcTime> plc_time;
  if (clock != nullptr) plc_time.emplace(*clock, stage.plant, links, stage.recorder);

  report_begin(stage, options, links, clock, out);
  warn_of_times(options, links, err);
  ReportedStandstill standstill(stage.plant, stage.recorder);
  exec::MonotonicClock wall;
  exec::CycleMeter meter;
  PanelStatus status(links, &meter);
  if (panel != nullptr) {
    panel->set_status([&status] { return status.text(); });
    panel->set_links([&status] { return status.states(); });
  }
  exec::Stepper* stepper = stage.stepper(panel != nullptr ? &panel->stepper() : nullptr);
  LinkCommands commands(links, stage.plant, stage.recorder, stepper);
  if (!commands.empty()) stepper = &commands;
  const auto cycles = [&] {
    exec::run_cycles(stage.plant, watched.exchanges(), cycle,
                     {.clock = wall,
                      .meter = meter,
                      .stop = stop_requested(),
                      .observer = &stage.recorder,
                      .stepper = stepper,
                      .plc_time = plc_time ? &*plc_time : nullptr,
                      .standstill = &standstill});
    if (stage.programs) stage.programs->end();
  };
  CycleThread thread(options.real_time, cycles, options.rt_check.has_value());
  RealRun run;
  run.asked = options.real_time.any();
  run.refused = thread.refused();
  for (const exec::Refusal& refusal : run.refused) err << "warning: " << refusal.message << "\n";
  err.flush();
  Waits waits = waits_of(stage, links, clock);  // before another thread uses the report
  {
    const Untied untied(err);
    stage.outputs.start_thread();
    {
      const Attendant attendant(meter, links, std::move(waits), !run.refused.empty(), can_draw(options, out),
                                streams.console);
      thread.go();
      thread.join();
      let_end_be_read(links);
    }
    stage.outputs.stop_thread();
  }
  if (panel != nullptr) {
    panel->set_status(nullptr);
    panel->set_links(nullptr);
  }

  run.cycles = meter.statistics();
  run.faults = thread.faults();
  const bool over = cycle.ends_when_over && stage.player->over();
  const bool ended_early = cycle.until != tables::kNever && stage.plant.now() < cycle.until && !over;
  run.plcs = judge_plcs(stage, links, clock, run.cycles, ended_early && !stop_requested().load());
  report_end(stage, run, links, out);
  if (options.rt_check) run.clean = report_rt_check(thread.report(), run.faults, run.cycles.cycles, stage, out);
  return run;
}

}  // namespace symplant::host

// Runs a plant from start to end.
#include "symplant/host/run.hpp"

#include <chrono>
#include <filesystem>
#include <ostream>
#include <string>
#include <utility>

#include "symplant/exec/rt_check.hpp"
#include "symplant/host/console.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/files_apart.hpp"
#include "symplant/host/junit.hpp"
#include "symplant/host/last_resort.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/load_scenario.hpp"
#include "symplant/host/panel_run.hpp"
#include "symplant/host/plc_clock.hpp"
#include "symplant/host/rt_check.hpp"
#include "symplant/host/run_paced.hpp"
#include "symplant/host/run_real.hpp"
#include "symplant/host/run_virtual.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/host/stage.hpp"
#include "symplant/host/stats.hpp"
#include "symplant/host/summary.hpp"
#include "symplant/host/why.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::host {
namespace {

/// The files that are written at the end. They are opened at the start, so that an error shows before a long run.
class LastFiles {
 public:
  LastFiles(const RunOptions& options, std::ostream& out) : out_(out) {
    open(junit_, "JUnit file", options.junit);
    open(stats_, "statistics", options.stats);
  }

  bool are_well(std::ostream& err) const {
    bool well = true;
    for (const auto* file : {&junit_, &stats_}) {
      if (!*file || (*file)->error().empty()) continue;
      err << "error: " << (*file)->error() << "\n";
      well = false;
    }
    return well;
  }

  template <class Text>
  void junit(Text text) {
    write(junit_, text);
  }
  template <class Text>
  void stats(Text text) {
    write(stats_, text);
  }

 private:
  void open(std::optional<trace::OutputFile>& file, const char* what, const std::string& path) {
    if (path.empty()) return;
    if (is_standard_output(path)) {
      file.emplace(what, out_);
    } else {
      file.emplace(what, path);
    }
  }
  template <class Text>
  static void write(std::optional<trace::OutputFile>& file, Text text) {
    if (!file) return;
    file->put(text());
    file->flush();
  }

  std::ostream& out_;
  std::optional<trace::OutputFile> junit_;
  std::optional<trace::OutputFile> stats_;
};

int exit_code(const RunOptions& options, const Report& report, const std::optional<scenario::Verdict>& verdict) {
  const bool expected = !verdict || verdict->failed + verdict->unreached == 0;
  const bool required = report.requirements_violated() == 0;
  const bool found = options.fail_on_findings && report.findings() != 0;
  return expected && required && !found ? kGood : kFindings;
}

/// Warns of given options without effect in this run.
void report_without_effect(const RunOptions& options, bool real, bool linked, bool by_plc, std::ostream& err) {
  const std::pair<const char*, bool> of_real_time[] = {{"--cycle", options.cycle_given && !options.rt_check},
                                                       {"--on-loss", options.on_loss.has_value()},
                                                       {"--late", options.late_given},
                                                       {"--priority", options.real_time.priority.has_value()},
                                                       {"--cpu", options.real_time.cpu.has_value()},
                                                       {"--lock-memory", options.real_time.lock_memory},
                                                       {"--stay-awake", options.real_time.stay_awake},
                                                       {"--spin", options.spin != 0}};
  std::string names;
  std::size_t count = 0;
  for (const auto& [name, given] : of_real_time) {
    if (real || !given) continue;
    names += (count++ == 0 ? "`" : ", `") + std::string(name) + "`";
  }
  if (count != 0) {
    err << "warning: " << names << (count == 1 ? " has" : " have")
        << " no effect in virtual time; to run in real time, add `--clock real`\n";
  }
  if (by_plc && options.late_given) {
    err << "warning: `--late` has no effect, since plant time follows the PLC's clock; to follow the wall clock, add "
           "`--clock real`\n";
  }
  if (real && !linked && options.on_loss) {
    err << "warning: `--on-loss` has no effect without a link that can be lost; add one with `--link`\n";
  }
  if (options.trace_limit != trace::kNoLimit && options.trace.empty() && options.vcd.empty()) {
    err << "warning: `--trace-limit` has no effect without `--trace` or `--vcd`; add one of them\n";
  }
}

/// False, with a message on `err`, if the options of time contradict each other. `clock` may be null.
bool times_fit(const RunOptions& options, const PlcClockChoice* clock, std::ostream& err) {
  if (options.rt_check && clock != nullptr) {
    err << "error: `--rt-check` counts cycles of the wall clock, but plant time is that of `" << clock->name
        << "`: use `--clock real`\n";
    return false;
  }
  if (options.rt_check && options.panel && options.clock != RunOptions::Clock::real_time) {
    err << "error: `--rt-check` with `--panel` needs the real-time cycle: add `--clock real`\n";
    return false;
  }
  if (options.rt_check && options.until) {
    err << "error: `--rt-check` already sets the length of the run, in cycles: remove `--until`\n";
    return false;
  }
  if (options.spin >= options.cycle) {
    err << "error: `--spin` of " << trace::seconds(options.spin) << " is not shorter than the cycle of "
        << trace::seconds(options.cycle) << ": give less, such as 100us\n";
    return false;
  }
  return true;
}

/// The state from which a run starts.
struct Resumed {
  std::string name;
  trace::Snapshot snapshot;
};

/// Reads the snapshot of `--resume` or of the scenario, if there is one. Returns false with a message on `err` on
/// error.
bool read_resumed(const Stage& stage, const RunOptions& options, const scenario::Scenario* scenario,
                  std::optional<Resumed>& resumed, std::ostream& err) {
  const std::string by_scenario = scenario != nullptr ? scenario->restore : std::string();
  if (!by_scenario.empty() && !options.resume.empty()) {
    err << "error: the scenario starts from the snapshot `" << by_scenario << "`: remove `--resume`\n";
    return false;
  }
  const std::string& path = by_scenario.empty() ? options.resume : by_scenario;
  if (path.empty()) return true;
  trace::ReadSnapshot read = trace::read_snapshot(path, stage.plant.model_hash(), stage.plant.save().size());
  if (!read.error.empty()) {
    err << "error: " << read.error << "\n";
    return false;
  }
  resumed = Resumed{std::filesystem::path(path).stem().string(), std::move(read.snapshot)};
  return true;
}

/// Writes the state at the end, if that is asked for. False, with a message on `err`, on error.
bool save_end(const Stage& stage, const RunOptions& options, std::ostream& err) {
  if (options.save.empty()) return true;
  const std::string error =
      trace::write_snapshot(options.save, stage.plant.tables().name, trace::Snapshot::of(stage.plant));
  if (!error.empty()) err << "error: " << error << "\n";
  return error.empty();
}

/// What a run plays.
struct Played {
  const PlantProgram& program;
  const RunOptions& options;
  trace::PlantNames& names;
  const scenario::Scenario* scenario;  ///< null: none
  const LinkChoices& links;
  const std::vector<bool>& carried;  ///< by symbol: whether one of the links carries it
  const std::vector<Question>& questions;
  bool real;                    ///< in real time
  const PlcClockChoice* clock;  ///< null: the wall clock
  const Resumed* resumed;       ///< null: from the initial state
};

/// Runs the plant from time 0 to the end. Returns the exit code.
int play(Stage& stage, const Played& played, LastResort& resort, const RunStreams& streams) {
  const PlantProgram& program = played.program;
  const RunOptions& options = played.options;
  // So that links answer from the plant's initial state, or what was written to a saved one takes effect.
  stage.advance_to(stage.plant.now());
  Links links;
  const int opened = open_links(played.links, program.tables, stage.plant, links, streams.err);
  if (opened != kGood) return opened;
  std::vector<trace::PlantNames::Link> named;
  for (const OpenLink& open : links) named.push_back({open.text(), open.silence()});
  played.names.name_links(std::move(named));
  LastFiles last(options, streams.out);
  if (!stage.outputs.open(stage.plant.model_hash(), streams.err) || !last.are_well(streams.err)) return kEnvironment;
  if (played.resumed != nullptr) stage.outputs.set_back("restored", played.resumed->name, stage.plant.now());
  resort.begun();
  streams.report << summary(program.tables, stage.plant.model_hash(), program.more, program.behaviours)
                 << behaviour_lines(program.tables, program.behaviours);
  if (!played.real) streams.report << cut_link_lines(program.tables);
  if (played.scenario != nullptr) streams.report << scenario_summary(options.scenario, *played.scenario);
  if (options.links.empty() && keeps_plants_links_closed(options) &&
      !(program.links.empty() && program.default_link.empty())) {
    streams.report << "links of the plant are not opened in virtual time; to open them, use --clock real\n";
  }

  std::unique_ptr<panel::Panel> panel;
  const int served = open_panel({program, options, played.names, played.carried, played.scenario, links,
                                 has_real_link(played.links), played.clock != nullptr, played.real,
                                 played.resumed != nullptr ? played.resumed->name : std::string(), streams.console},
                                stage, streams.report, streams.err, panel);
  if (served != kGood) return served;

  const auto begin = std::chrono::steady_clock::now();
  std::optional<RealRun> real_run;
  bool clean = true;
  if (played.real) {
    real_run = run_real(stage, options, links, played.clock, panel.get(), streams);
    clean = !report_missing_cycles(real_run->cycles.cycles, options, streams.report) && real_run->clean;
  } else if (options.rt_check) {
    clean = run_rt_check(stage, options, links, streams.report);
  } else if (panel != nullptr) {
    run_paced(stage, options, *panel, streams.report);
  } else {
    run_virtual(stage, options, streams.report);
  }
  const std::chrono::nanoseconds wall = std::chrono::steady_clock::now() - begin;
  stage.outputs.drain();
  stage.outputs.hide();
  panel.reset();

  if (stage.player) stage.player->end();
  const auto outcomes = stage.player ? stage.player->outcomes() : std::span<const scenario::Outcome>();
  stage.outputs.finish(stage.plant.now(), streams.err);
  stage.report.sum_up(stage.plant, outcomes, stage.recorder.lost_findings(), streams.report);
  const std::vector<Answer> answers = answers_to(played.questions, stage, {links, played.carried, played.scenario});
  streams.report << answers_text(answers);
  std::optional<scenario::Verdict> verdict;
  if (played.scenario != nullptr) verdict = scenario::verdict_of(*played.scenario, outcomes);
  last.junit([&] {
    return junit_text(stage.plant, played.names, played.scenario, outcomes, stage.report, options.fail_on_findings);
  });
  last.stats([&] {
    return stats_text({stage.plant, options.seed, stage.outputs, stage.report, verdict, real_run, played.clock, links,
                       answers, played.names, tables::Time{wall.count()}});
  });
  if (!last.are_well(streams.err) || !save_end(stage, options, streams.err)) return kEnvironment;
  return clean ? exit_code(options, stage.report, verdict) : kFindings;
}

}  // namespace

int run(const PlantProgram& program, const RunOptions& options, std::ostream& out, std::ostream& err) {
  const auto planned = links_of(program, options);
  if (const auto* error = std::get_if<link::LinkError>(&planned)) {
    err << "error: " << error->message << "\n";
    return kBadInput;
  }
  const auto& chosen = std::get<LinkChoices>(planned);
  const bool linked = has_real_link(chosen);
  if (linked && options.clock == RunOptions::Clock::virtual_time) {
    err << "error: a link to a PLC needs real time: remove `--clock virtual`\n";
    return kBadInput;
  }
  const ChosenPlcClock chosen_clock = choose_plc_clock(program, options, chosen);
  if (!chosen_clock.error.empty()) {
    err << "error: " << chosen_clock.error << "\n";
    return kBadInput;
  }
  if (!chosen_clock.warning.empty()) err << "warning: " << chosen_clock.warning << "\n";
  const PlcClockChoice* const clock = chosen_clock.clock ? &*chosen_clock.clock : nullptr;
  if (!files_are_apart(options, program.inputs, err)) return kBadInput;
  trace::PlantNames names(program.tables);
  const std::vector<bool> carried = carried_symbols(chosen, program.tables);
  const auto questions = questions_of(options.why, names, err);
  if (!questions) return kBadInput;
  std::optional<scenario::Scenario> scenario;
  if (!options.scenario.empty()) {
    scenario = load_scenario(options.scenario, names, carried, err);
    if (!scenario) return kBadInput;
  }
  catch_signals();
  LastResort resort;
  const scenario::Scenario* const played = scenario ? &*scenario : nullptr;
  // A panel without a PLC sets the speed of plant time, unless the guard or the user asks for the real-time cycle.
  const bool real = linked || options.clock == RunOptions::Clock::real_time;
  if (!times_fit(options, clock, err)) return kBadInput;
  report_without_effect(options, real, linked, clock != nullptr, err);
  if (options.arm && !goes_to_plc(chosen)) {
    err << "warning: `--arm` has no effect without a link that goes to a PLC, such as `slmp:`\n";
  }
  PlantProgram staged = program;
  std::optional<exec::WatchedBehaviours> watched;
  if (options.rt_check) staged.behaviours = watched.emplace(program.tables, program.behaviours).watched();
  std::ostream& report = uses_standard_output(options) ? err : out;
  Console console(report, err);
  const RunStreams streams{out, err, report, console};
  Stage stage(staged, options, names, played, real, streams);
  if (linked) stage.outputs.report_short_events_of(carried);
  std::optional<Resumed> resumed;
  if (!read_resumed(stage, options, played, resumed, err)) return kBadInput;
  if (resumed && !stage.resume(resumed->snapshot)) {
    err << "error: the snapshot `" << resumed->name << "` is damaged: make it again\n";
    return kBadInput;
  }
  const Resumed* const from = resumed ? &*resumed : nullptr;
  const int code =
      play(stage, {program, options, names, played, chosen, carried, *questions, real, clock, from}, resort, streams);
  out.flush();  // while LastResort still detects a blocked output
  return code;
}

}  // namespace symplant::host

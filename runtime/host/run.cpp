// Runs a plant from start to end.
#include "symplant/host/run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <ostream>
#include <string>
#include <utility>

#include "symplant/exec/rt_check.hpp"
#include "symplant/host/console.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/fault_start.hpp"
#include "symplant/host/files_apart.hpp"
#include "symplant/host/junit.hpp"
#include "symplant/host/last_resort.hpp"
#include "symplant/host/links.hpp"
#include "symplant/host/load_scenario.hpp"
#include "symplant/host/panel_run.hpp"
#include "symplant/host/plc_clock.hpp"
#include "symplant/host/plc_verdict.hpp"
#include "symplant/host/programs.hpp"
#include "symplant/host/read_replay.hpp"
#include "symplant/host/result_files.hpp"
#include "symplant/host/rt_check.hpp"
#include "symplant/host/run_paced.hpp"
#include "symplant/host/run_real.hpp"
#include "symplant/host/run_replay.hpp"
#include "symplant/host/run_virtual.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/host/stage.hpp"
#include "symplant/host/stats.hpp"
#include "symplant/host/summary.hpp"
#include "symplant/host/why.hpp"
#include "symplant/host/without_effect.hpp"
#include "symplant/host/words.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::host {
namespace {

/// The results of a run that has ended.
struct Ended {
  const std::optional<scenario::Verdict>& verdict;  ///< nothing: without a scenario
  const PlcVerdict* plcs;                           ///< null: without a link to a PLC
  bool clean;                                       ///< --rt-check found nothing
};

/// Whether the run is to show something, so that it has failed if no PLC came or plant time did not run.
bool is_test(const RunOptions& options) {
  return !options.scenario.empty() || !options.junit.empty() || options.fail_on_findings;
}

/// That of a run without an error.
int exit_code(const RunOptions& options, const Report& report, const Ended& ended) {
  const bool expected = !ended.verdict || ended.verdict->failed + ended.verdict->unreached == 0;
  const bool required = report.requirements_violated() == 0;
  const bool found = options.fail_on_findings && report.findings() != 0;
  const bool exchanged = ended.plcs == nullptr || !is_test(options) ||
                         (report.count(tables::FindingKind::no_plc) == 0 && ended.plcs->stalled.empty());
  return ended.clean && expected && required && !found && exchanged ? kGood : kFindings;
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
  resumed = Resumed{std::filesystem::path(path).stem().generic_string(), std::move(read.snapshot)};
  return true;
}

/// Writes the state at the end, if that is asked for. Returns the error; empty without one.
std::string save_end(const Stage& stage, const RunOptions& options) {
  if (options.save.empty()) return "";
  return trace::write_snapshot(options.save, stage.plant.tables().name, trace::Snapshot::of(stage.plant));
}

/// Lets programs run with the plant of a stage; `real`: in the cycle.
void add_programs(const Programs& programs, bool real, Stage& stage) {
  stage.programs.emplace(stage.plant, &stage.recorder);
  if (real) stage.programs->share_events();
  for (const OpenProgram& one : programs) stage.programs->add(one.loaded->program(), one.choice.options);
  stage.stepper(nullptr);
  if (stage.player) stage.player->control(&*stage.programs);
}

/// What a run plays.
struct Played {
  const PlantProgram& program;
  const RunOptions& options;
  trace::PlantNames& names;
  const scenario::Scenario* scenario;  ///< null: none
  const Replay* replay;                ///< null: none
  const LinkChoices& links;
  const Programs& programs;
  const std::vector<bool>& carried;  ///< by symbol: whether one of the links carries it
  const std::vector<Question>& questions;
  bool real;                    ///< in real time
  const PlcClockChoice* clock;  ///< null: the wall clock
  const Resumed* resumed;       ///< null: from the initial state
  ResultFiles& files;
};

/// Reports what the plant is, and what this run does not do with it.
void report_plant(const Played& played, const Links& links, const Stage& stage, const RunStreams& streams) {
  const PlantProgram& program = played.program;
  streams.report << summary(program.tables, stage.plant.model_hash(), program.more, program.behaviours)
                 << behaviour_lines(program.tables, program.behaviours) << formula_lines(program.tables.values);
  if (!played.real && played.replay == nullptr) {
    std::vector<bool> with_program(program.tables.symbols.size());
    for (const OpenProgram& one : played.programs) with_program[one.choice.options.controller] = true;
    streams.report << cut_link_lines(program.tables, with_program);
  }
  streams.report << program_lines(played.programs, program.tables);
  if (played.scenario != nullptr) streams.report << scenario_summary(played.options.scenario, *played.scenario);
  if (stage.fault) {
    streams.report << fmt::format("fault: `{}` from {}\n", shown(played.options.fault),
                                  trace::seconds(played.options.fault_at));
  }
  if (played.replay != nullptr) streams.report << replay_summary(played.options.replay, *played.replay);
  if (played.options.links.empty() && keeps_plants_links_closed(played.options, !played.programs.empty()) &&
      !(program.links.empty() && program.default_link.empty())) {
    streams.report << "links of the plant are not opened in virtual time; to open them, use --clock real\n";
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::string left_out = left_out_words(played.links[i], program.tables);
    if (!left_out.empty()) streams.err << "warning: link " << links[i].text() << " " << left_out << "\n";
  }
}

/// Opens the links and the files. Returns the exit code of the first failure, with a message on `streams.err`, or 0.
int open_all(Stage& stage, const Played& played, Links& links, const RunStreams& streams) {
  const int opened = open_links(played.links, played.program.tables, stage.plant, links, streams.err);
  if (opened != kGood) return opened;
  played.names.name_links(named_links(links));
  const bool outputs =
      stage.outputs.open(stage.plant.model_hash(), played.real ? played.options.cycle : 0, streams.err);
  if (!played.files.open(played.program.tables.name, streams.err) || !outputs) return kEnvironment;
  if (played.resumed != nullptr) stage.outputs.set_back("restored", played.resumed->name, stage.plant.now());
  return kGood;
}

/// What the run itself has shown.
struct Shown {
  std::optional<RealRun> real;  ///< only in real time
  std::optional<bool> clean;    ///< with --rt-check: whether it found nothing
  tables::Time wall = 0;        ///< its duration, in ns
  std::vector<Answer> answers;  ///< to --why, at its end
};

Shown run_to_end(Stage& stage, const Played& played, const Links& links, panel::Panel* panel,
                 const RunStreams& streams) {
  const RunOptions& options = played.options;
  Shown shown;
  const auto begin = std::chrono::steady_clock::now();
  if (played.replay != nullptr) {
    run_replay(stage, *played.replay, options, streams.report);
  } else if (played.real) {
    shown.real = run_real(stage, options, links, played.clock, panel, streams);
    if (options.rt_check) {
      shown.clean = !report_missing_cycles(shown.real->cycles.cycles, options, streams.report) && shown.real->clean;
    }
  } else if (options.rt_check) {
    shown.clean = run_rt_check(stage, options, links, streams.report);
  } else if (panel != nullptr) {
    run_paced(stage, options, *panel, streams.report);
  } else {
    run_virtual(stage, options, streams.report);
  }
  shown.wall = (std::chrono::steady_clock::now() - begin).count();
  return shown;
}

/// Sums up a run that has ended, and writes its results. Returns the exit code.
int sum_up(Stage& stage, const Played& played, const Links& links, const Shown& shown, const RunStreams& streams) {
  const RunOptions& options = played.options;
  const bool cut = options.limit && stage.player && !stage.player->over() && stage.plant.now() >= *options.limit;
  if (stage.player) stage.player->end();
  const auto outcomes = stage.player ? stage.player->outcomes() : std::span<const scenario::Outcome>();
  if (options.end != nullptr) *options.end = stage.plant.now();
  stage.outputs.finish(stage.plant.now(), streams.err);
  if (stage.fault && stage.fault->next() != tables::kNever) {
    streams.err << fmt::format("warning: the run ended before {}, when the malfunction of `--fault` was to start\n",
                               trace::seconds(stage.fault->next()));
  }
  stage.report.sum_up(stage.plant, outcomes, stage.recorder.lost_findings(), streams.report);
  streams.report << answers_text(shown.answers);
  std::optional<scenario::Verdict> verdict;
  if (played.scenario != nullptr) verdict = scenario::verdict_of(*played.scenario, outcomes);
  const PlcVerdict* const plcs = shown.real && has_real_link(played.links) ? &shown.real->plcs : nullptr;
  const int code = exit_code(options, stage.report, {verdict, plcs, shown.clean.value_or(true)});
  if (plcs != nullptr && !plcs->stalled.empty()) {
    streams.err << (is_test(options) ? "error: " : "warning: ") << plcs->stalled << "\n";
  }

  if (cut)
    streams.err << "error: the scenario is not over after its limit of " << trace::seconds(*options.limit) << "\n";

  std::string errors;
  const auto note = [&](const std::string& error) {
    if (error.empty()) return;
    streams.err << "error: " << error << "\n";
    errors += (errors.empty() ? "" : "\n") + error;
  };
  if (plcs != nullptr) note(plcs->unreached);
  if (stage.programs && stage.programs->failed()) note(program::failure_words(*stage.programs->failure()));
  note(played.files.write_stats(
      stats_text(options.stats, {stage.plant, options.seed, stage.outputs, stage.report, verdict, shown.real,
                                 played.clock, links, shown.answers, played.names, shown.wall})));
  note(save_end(stage, options));
  note(played.files.write_junit(junit_text({stage.plant, played.names, played.scenario, outcomes, stage.report,
                                            options.fail_on_findings, shown.clean, plcs, errors})));
  if (!errors.empty()) return kEnvironment;
  return cut ? kFindings : code;
}

/// Runs the plant from time 0 to the end. Returns the exit code.
int play(Stage& stage, const Played& played, LastResort& resort, const RunStreams& streams) {
  // So that links answer from the plant's initial state, or what was written to a saved one takes effect.
  if (played.replay == nullptr) stage.advance_without_programs(stage.plant.now());
  Links links;
  const int opened = open_all(stage, played, links, streams);
  if (opened != kGood) return opened;
  resort.begun();
  report_plant(played, links, stage, streams);

  std::unique_ptr<panel::Panel> panel;
  const int served = open_panel({played.program, played.options, played.names, played.carried, played.scenario, links,
                                 has_real_link(played.links), played.clock != nullptr, played.real,
                                 played.resumed != nullptr ? played.resumed->name : std::string(), streams.console},
                                stage, streams.report, streams.err, panel);
  if (served != kGood) return served;
  if (!played.programs.empty()) streams.report.flush();  // a program may end the process
  Shown shown = run_to_end(stage, played, links, panel.get(), streams);
  stage.outputs.drain();
  shown.answers = answers_to(played.questions, stage,
                             {links, played.carried, panel != nullptr ? panel->playing() : played.scenario,
                              panel != nullptr && panel->frozen()});
  stage.outputs.hide();
  panel.reset();
  return sum_up(stage, played, links, shown, streams);
}

/// run(), with its result files.
int run_with(ResultFiles& files, const PlantProgram& program, const RunOptions& given, std::ostream& out,
             std::ostream& err) {
  if (!files_are_apart(given, program.inputs, err)) return kBadInput;
  files.replace_unless_among(program.inputs);
  if (!replay_fits(given, err)) return kBadInput;
  trace::PlantNames names(program.tables);
  std::optional<Replay> replay;
  if (!given.replay.empty()) {
    replay = load_replay(given.replay, names, err);
    if (!replay) return kBadInput;
  }
  const RunOptions options = replay ? options_of_replay(given, *replay) : given;
  const auto chosen_programs = replay ? std::variant<ProgramChoices, std::string>() : programs_of(program, options);
  if (const auto* error = std::get_if<std::string>(&chosen_programs)) {
    err << "error: " << *error << "\n";
    return kBadInput;
  }
  const auto& program_choices = std::get<ProgramChoices>(chosen_programs);
  const auto planned = links_of(program, options, controllers_of(program_choices));
  if (const auto* error = std::get_if<link::LinkError>(&planned)) {
    err << "error: " << error->message << "\n";
    return kBadInput;
  }
  const auto& chosen = std::get<LinkChoices>(planned);
  const bool linked = has_real_link(chosen);
  if (const std::string both = link_beside_program(program_choices, chosen, program.tables); !both.empty()) {
    err << "error: " << both << "\n";
    return kBadInput;
  }
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
  std::vector<bool> carried = carried_symbols(chosen, program.tables);
  Programs programs;
  const int programs_opened = open_programs(program_choices, names, programs, err);
  if (programs_opened != kGood) {
    err << "note: `symplant program --check` shows how the variables of a program bind\n";
    return programs_opened;
  }
  add_written(programs, program.tables, carried);
  names.name_programs(named_programs(programs, program.tables));
  const auto questions = questions_of(options.why, names, err);
  if (!questions) return kBadInput;
  std::optional<scenario::Scenario> scenario;
  if (!options.scenario.empty()) {
    scenario = load_scenario(options.scenario, names, carried, err);
    if (!scenario) return kBadInput;
  }
  std::optional<std::uint32_t> fault;
  if (!options.fault.empty()) {
    fault = fault_of(options.fault, names, err);
    if (!fault) return kBadInput;
  }
  if (const std::string refused = refused_with_programs(options, scenario && !scenario->restore.empty());
      !programs.empty() && !refused.empty()) {
    err << "error: " << refused << "\n";
    return kBadInput;
  }
  catch_signals();
  LastResort resort;
  const scenario::Scenario* const played = scenario ? &*scenario : nullptr;
  // A panel without a PLC sets the speed of plant time, unless the guard or the user asks for the real-time cycle.
  const bool real = linked || options.clock == RunOptions::Clock::real_time;
  if (!times_fit(options, clock, err)) return kBadInput;
  report_without_effect(options, {real, linked, clock != nullptr, !programs.empty()}, err);
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
  if (!programs.empty()) add_programs(programs, real, stage);
  if (fault) stage.start_fault(*fault, options.fault_at);
  if (replay) report_other_run(stage, options, *replay, err);
  // What a program reads it reads at its scans, not at the ends of cycles.
  if (linked || (real && !programs.empty())) stage.outputs.report_short_events_of(carried);
  std::optional<Resumed> resumed;
  if (!read_resumed(stage, options, played, resumed, err)) return kBadInput;
  if (resumed && !stage.resume(resumed->snapshot)) {
    err << "error: the snapshot `" << resumed->name << "` is damaged: make it again\n";
    return kBadInput;
  }
  if (!options.stats.empty()) stage.plant.watch_outputs();
  const Resumed* const from = resumed ? &*resumed : nullptr;
  const int code = play(stage,
                        {program, options, names, played, replay ? &*replay : nullptr, chosen, programs, carried,
                         *questions, real, clock, from, files},
                        resort, streams);
  out.flush();  // while LastResort still detects a blocked output
  return code;
}

}  // namespace

int run(const PlantProgram& program, const RunOptions& options, std::ostream& out, std::ostream& err) {
  return with_results(options, program.tables.name, out, err,
                      [&](ResultFiles& files) { return run_with(files, program, options, out, err); });
}

}  // namespace symplant::host

// symplant campaign: every single fault of a plant against a program.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/batch_options.hpp"
#include "app/commands.hpp"
#include "app/options.hpp"
#include "app/prepared_plant.hpp"
#include "app/progress.hpp"
#include "app/with_faults.hpp"
#include "batch/workers.hpp"
#include "campaign/report.hpp"
#include "campaign/run_fault.hpp"
#include "diag/visible_text.hpp"
#include "elements/alarm/skeleton.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/program/library.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/tables/duration.hpp"
#include "symplant/tables/nearest.hpp"
#include "symplant/tables/version.hpp"
#include "symplant/trace/words.hpp"
#include "text/shell_word.hpp"

namespace symplant::app {
namespace {

constexpr std::size_t kMostFaults = 12;  ///< of a class, in the table on the terminal

struct CampaignOptions : BatchOptions {
  std::string plant;
  PlantOptions plant_options;
  campaign::Setup setup;
  std::string faults = "all";  ///< or the file of a list
  campaign::Phases phases = campaign::Phases::start;
  campaign::Classes fail_on;
  std::string csv;
  std::string command;  ///< repeats a run, without the options of its fault
};

/// What the reports say of the plant.
struct CampaignPlant {
  std::string name;
  std::uint64_t model_hash = 0;
  std::vector<std::string> alarm_names;
  std::size_t requirements = 0;

  explicit CampaignPlant(const Compiled& compiled)
      : name(compiled.plant.name),
        model_hash(tables::model_hash(compiled.tables.tables())),
        requirements(compiled.plant.requirements.size()) {
    for (const model::Alarm& alarm : compiled.plant.alarms) {
      alarm_names.emplace_back(alarm.symbol != model::kNone ? compiled.plant.symbols[alarm.symbol].name()
                                                            : compiled.plant.values[alarm.value].name);
    }
  }
};

/// What the outputs may not replace. `plant_files`: the files that the plant is read from.
std::vector<std::string> inputs_of(const CampaignOptions& options, const std::vector<std::string>& plant_files) {
  std::vector<std::string> inputs = options.merged;
  for (const std::string& input : {options.plant, options.setup.scenario, options.plant_options.malfunctions})
    if (!input.empty()) inputs.push_back(input);
  for (const std::string& program : options.setup.run.programs) inputs.push_back(program.substr(program.find('=') + 1));
  inputs.insert(inputs.end(), plant_files.begin(), plant_files.end());
  return inputs;
}

/// Whether no output is an input or another output. If not, reports it and sets the exit code.
bool are_apart(const CampaignOptions& options, const std::vector<std::string>& inputs, Context& context) {
  std::set<std::filesystem::path> outputs;
  for (const std::string& output : {options.output, options.junit, options.csv, options.html}) {
    if (output.empty() || output == "-") continue;
    if (overwrites(context, output, inputs)) return false;
    std::error_code unknown;  // an output that has no folder fails where it is written
    if (outputs.insert(std::filesystem::weakly_canonical(output, unknown)).second) continue;
    context.err << "error: `" << output << "` is given for two outputs; name another file\n";
    context.exit_code = host::kBadInput;
    return false;
  }
  return true;
}

/// begin_reports(), also for the table.
bool begin_all(const CampaignOptions& options, const std::vector<std::string>& inputs, Context& context) {
  if (!are_apart(options, inputs, context) || !begin_reports(options, "symplant campaign", inputs, context))
    return false;
  return options.csv.empty() || write_result(context, options.csv, base::whole("the run has not ended\n"), inputs);
}

/// Writes the reports. False, with a message and the exit code, if that fails.
bool write_reports(const CampaignOptions& options, const campaign::Results& results, const campaign::Overview& overview,
                   Context& context) {
  if (!options.junit.empty()) {
    const std::string junit = campaign::junit_text(results, overview, options.fail_on);
    if (!write_result(context, options.junit, base::whole(junit), {})) return false;
  }
  const base::TextSource csv = [&](base::TextSink& sink) { campaign::write_csv(results, overview, sink); };
  if (!options.csv.empty() && !write_result(context, options.csv, csv, {})) return false;
  const base::TextSource page = [&](base::TextSink& sink) { campaign::write_html(results, overview, sink); };
  return options.html.empty() || write_result(context, options.html, page, {});
}

/// Sums up what there is. `of_part`: how many results of other parts are missing, which is no fault of this one.
void end_campaign(const CampaignOptions& options, const campaign::Results& results, std::size_t of_part,
                  Context& context) {
  campaign::Overview overview = campaign::overview_of(results);
  overview.missing -= std::min(overview.missing, of_part);
  campaign::write_table(results, overview, kMostFaults, context.out);
  context.out << campaign::summary(overview) << "\n";
  if (!write_reports(options, results, overview, context)) return;
  context.exit_code = campaign::fails(overview, options.fail_on) ? host::kFindings : host::kGood;
}

std::string duration_words(double seconds) {
  return seconds < 90 ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.0f} min", seconds / 60);
}

class CampaignRun {
 public:
  CampaignRun(const CampaignOptions& options, const campaign::Campaign& campaign,
              const std::vector<campaign::Planned>& planned, Context& context)
      : options_(options),
        campaign_(campaign),
        planned_(planned),
        context_(context),
        progress_(context.err, context.progress) {}

  void run(batch::Header header) {
    std::string error;
    campaign::Results results(std::move(header), options_.output, error);
    std::size_t others = 0;
    for (std::size_t number = 0; number < planned_.size() && error.empty(); ++number) {
      if (!options_.shard.has(number)) {
        ++others;
      } else if (planned_[number].needed) {
        mine_.push_back(number);
      } else {
        error = results.add(number, campaign::result_of(campaign_, planned_[number]));
      }
    }
    if (!error.empty()) return fail_batch(context_, error, host::kEnvironment);
    const auto work = [&](std::size_t piece) { return campaign::run_fault(campaign_, planned_[mine_[piece]]).line(); };
    const auto done = [&](const batch::Done& piece) {
      std::string failed = results.add(mine_[piece.piece], result_of(piece));
      if (!failed.empty() && error.empty()) error = std::move(failed);
      ++done_;
      show_progress();
    };
    const auto stop = [&] { return host::stop_requested().load() || !error.empty(); };
    const std::string failed = batch::do_in_processes(mine_.size(), jobs_of(options_), work, done, stop);
    progress_.clear();
    if (!failed.empty() && error.empty()) error = failed;
    if (!error.empty()) return fail_batch(context_, error, host::kEnvironment);
    if (host::stop_requested().load()) {
      context_.err << fmt::format("warning: ended by a signal: {} of {} faults were run\n", done_, mine_.size());
    }
    end_campaign(options_, results, others, context_);
  }

 private:
  /// Of a process that ended, what it wrote last.
  campaign::Result result_of(const batch::Done& piece) const {
    if (auto result = campaign::Result::of_line(piece.answer)) return std::move(*result);
    campaign::Result crashed = campaign::result_of(campaign_, planned_[mine_[piece.piece]]);
    crashed.reaction = piece.words.substr(0, piece.words.find_last_not_of('\n') + 1);
    return crashed;
  }

  void show_progress() {
    using Seconds = std::chrono::duration<double>;
    const double spent = Seconds(std::chrono::steady_clock::now() - begin_).count();
    const double left = spent / static_cast<double>(done_) * static_cast<double>(mine_.size() - done_);
    progress_.stage(fmt::format("{} of {} faults, about {} left", done_, mine_.size(), duration_words(left)));
  }

  const CampaignOptions& options_;
  const campaign::Campaign& campaign_;
  const std::vector<campaign::Planned>& planned_;
  Context& context_;
  std::vector<std::size_t> mine_;  ///< those of this part that are run
  std::size_t done_ = 0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Progress progress_;
};

/// What a campaign is about, for its results: `plant` in the header, the rest for the page. In real time, lengths
/// differ from run to run, and are left out, so that parts have one header.
batch::Header header_of(const CampaignOptions& options, const CampaignPlant& plant, const campaign::BaseCase& base,
                        std::size_t results) {
  nlohmann::ordered_json about = nlohmann::ordered_json::array();
  const auto add = [&](const char* what, const std::string& text) {
    if (!text.empty()) about.push_back({what, diag::visible(text)});
  };
  add("Base case", options.setup.scenario);
  add("Program", fmt::format("{}", fmt::join(base.programs, ", ")));
  add("PLC at", fmt::format("{}", fmt::join(options.links, ", ")));
  if (base.in_virtual_time) {
    add("Length of each run", trace::seconds(base.log.end));
    add("Longest pause of the base case", trace::seconds(base.pause));
  }
  add("Alarms", plant.alarm_names.empty() ? "none" : fmt::format("{}", fmt::join(plant.alarm_names, ", ")));
  add("Requirements", std::to_string(plant.requirements));
  add("Model of the plant", fmt::format("{:016x}", plant.model_hash));
  add("Made by", fmt::format("symplant {}", tables::version()));
  // What makes results comparable, so that parts of different campaigns are not joined.
  const std::string identity = fmt::format(
      "{} {} {} {}", options.command, options.phases == campaign::Phases::all ? "all" : "start",
      program::file_digest(options.setup.scenario), program::file_digest(options.plant_options.malfunctions));
  const nlohmann::ordered_json more{
      {"about", about}, {"alarms", plant.alarm_names.size()}, {"identity", diag::visible(identity)}};
  return {campaign::kResultKey, plant.name, results, more.dump()};
}

/// The first names, and how many more there are.
std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 4;
  const auto end = names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), kMost));
  std::string text = fmt::format("`{}`", fmt::join(names.begin(), end, "`, `"));
  return names.size() > kMost ? text + fmt::format(" and {} more", names.size() - kMost) : text;
}

/// Without alarms no fault is detected.
void warn_of_missing_alarms(const model::PlantModel& plant, Context& context) {
  if (!plant.alarms.empty()) return;
  std::string text = "no fault is detected: ";
  if (!plant.description->alarms.empty()) {
    text += "the `alarms` of plant.json match no operation and no value";
  } else {
    text += "the plant has no `alarms`";
    const std::vector<std::string> proposed = emit::proposed_alarms(plant);
    text += proposed.empty() ? "; name those of the program in `alarms` of a plant.json"
                             : "; name them in a plant.json, maybe " + some_of(proposed);
  }
  context.err << "warning: " << diag::visible(text) << "\n";
}

/// An alarm that is on without a fault says little about faults.
void warn_of_alarms_in_base(const campaign::BaseCase& base, const campaign::PlantFacts& facts, Context& context) {
  std::vector<std::string> on;
  for (const model::Alarm& alarm : facts.alarms) {
    if (alarm.symbol == tables::kNone) continue;
    const bool inverted = facts.names.tables().symbols[alarm.symbol].inverted();
    const bool comes_on = std::any_of(
        base.log.symbols.begin(), base.log.symbols.end(),
        [&](const campaign::Change& change) { return change.of == alarm.symbol && (change.value != 0) != inverted; });
    if (comes_on) on.emplace_back(facts.names.symbol(alarm.symbol));
  }
  if (on.empty()) return;
  context.err << "warning: "
              << diag::visible(
                     "alarms that are on in the base case count only where they come on once more, or "
                     "earlier: " +
                     some_of(on))
              << "\n";
}

void run_campaign(const CampaignOptions& options, Context& context) {
  const bool from_file = options.faults != "all";
  std::optional<Compiled> compiled = compile_for(context, options.plant, options.plant_options);
  const int exit_code = context.exit_code;
  if (!begin_all(options, inputs_of(options, compiled ? compiled->plant.input_files() : std::vector<std::string>()),
                 context))
    return;
  context.exit_code = exit_code;
  if (!compiled) return;
  const std::size_t all = compiled->plant.malfunctions.size();
  const std::size_t own = compiled->own_malfunctions;
  const CampaignPlant about(*compiled);
  if (const std::vector<std::string> already = add_fault_malfunctions(*compiled); !already.empty()) {
    return fail_batch(context,
                      fmt::format("the malfunction `{}` of the plant has the name of a fault of campaigns: rename it",
                                  already.front()),
                      host::kBadInput);
  }
  const std::vector<campaign::Fault> faults =
      from_file ? campaign::described_faults(compiled->plant, own, all) : campaign::faults_of(compiled->plant, own);
  if (faults.empty()) {
    return fail_batch(context,
                      from_file ? "`" + options.faults + "` names no malfunction"
                                : "the plant has no input and no device, so nothing can fail",
                      host::kBadInput);
  }
  warn_of_missing_alarms(compiled->plant, context);
  const std::vector<model::Alarm> alarms = compiled->plant.alarms;
  std::vector<std::uint32_t> stations = campaign::stations_of(compiled->plant);
  const PreparedPlant prepared(std::move(*compiled), options.plant);
  compiled.reset();
  const host::PlantProgram plant = prepared.program();
  const trace::PlantNames names(plant.tables);
  const campaign::PlantFacts facts{names, alarms};
  std::string error;
  int code = host::kGood;
  host::catch_signals();
  const auto base = campaign::run_base(options.setup, plant, names, std::move(stations),
                                       options.phases == campaign::Phases::all ? 2 : 1, error, code);
  if (!base) return fail_batch(context, error, code);
  warn_of_alarms_in_base(*base, facts, context);
  const std::vector<campaign::Planned> planned = campaign::plan(faults, options.phases, *base, names);
  const campaign::Campaign campaign{options.setup, plant, facts, *base, faults, options.command};
  CampaignRun(options, campaign, planned, context).run(header_of(options, about, *base, planned.size()));
}

void merge_campaign(const CampaignOptions& options, Context& context) {
  if (!begin_all(options, inputs_of(options, {}), context)) return;
  batch::Header header;
  const auto read = [&](auto take) {
    return batch::read_results<campaign::Result>(options.merged, campaign::kResultKey, header, take);
  };
  std::string error = read([](std::size_t, const campaign::Result&) { return ""; });
  const auto more = nlohmann::ordered_json::parse(header.more, nullptr, false);
  if (error.empty() && !(more.is_object() && more.contains("about") && more["about"].is_array())) {
    error = options.merged.front() + ":1: these are no results of `symplant campaign -o`";
  }
  if (!error.empty()) return fail_batch(context, error, host::kBadInput);
  campaign::Results results(header, options.output, error);
  if (error.empty())
    error = read([&](std::size_t number, const campaign::Result& one) { return results.add(number, one); });
  if (!error.empty()) return fail_batch(context, error, host::kEnvironment);
  end_campaign(options, results, 0, context);
}

campaign::Classes read_classes(const std::string& text) {
  campaign::Classes classes;
  for (std::size_t begin = 0; begin <= text.size() && text != "none";) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string name = text.substr(begin, end - begin);
    const auto one = campaign::class_of(name);
    if (one == campaign::Class::error) {
      throw CLI::ValidationError("--fail-on", "an error always gives exit code 1: write the other classes only");
    }
    if (!one) {
      tables::NearestName nearest(name);
      for (std::size_t i = 0; i < campaign::kClasses; ++i)
        nearest.offer(campaign::class_name(static_cast<campaign::Class>(i)));
      throw CLI::ValidationError(
          "--fail-on",
          fmt::format("`{}` is no class: write violated, undetected, stopped, other, detected, no-effect, "
                      "or none{}",
                      name, nearest.name().empty() ? "" : fmt::format("; did you mean `{}`?", nearest.name())));
    }
    classes.set(static_cast<std::size_t>(*one));
    begin = end + 1;
  }
  return classes;
}

tables::Time read_time(const std::string& text, const char* option) {
  const auto time = tables::parse_duration(text);
  if (!time) throw CLI::ValidationError(option, "`" + text + "` is not a time such as 100ms");
  return *time;
}

/// The `symplant run` with the options of a campaign that change what a run does.
std::string repeating_command(const CLI::App& command, const CampaignOptions& options) {
  static constexpr std::array kOther{"--base",  "--phases", "--fail-on", "--csv",   "--window",
                                     "--limit", "--jobs",   "--shard",   "--merge", "--output",
                                     "--junit", "--html",   "--verbose", "--faults"};
  std::string text = fmt::format("symplant run {} --scenario {}", text::shell_word(options.plant),
                                 text::shell_word(options.setup.scenario));
  for (const CLI::Option* const option : command.get_options()) {
    const std::string name = option->get_name();
    const bool other = std::any_of(kOther.begin(), kOther.end(), [&](const char* one) { return name == one; });
    if (option->count() == 0 || other || name.substr(0, 2) != "--") continue;
    for (const std::string& value : option->results()) text += fmt::format(" {} {}", name, text::shell_word(value));
  }
  if (options.faults != "all") text += fmt::format(" --faults {}", text::shell_word(options.faults));
  return text;
}

void add_program_options(CLI::App& command, CampaignOptions& options) {
  host::RunOptions& run = options.setup.run;
  command.add_option("--program", run.programs, "the PLC program; with several controllers name one: PLC1=FILE")
      ->type_name("[CONTROLLER=]FILE")
      ->allow_extra_args(false);
  command.add_option("--link", options.links, "test the PLC at this link, in real time, one fault at a time")
      ->type_name("[CONTROLLER=]URL")
      ->allow_extra_args(false);
  const auto time_option = [&](const char* name, auto& to, const char* text) {
    command
        .add_option_function<std::string>(
            name, [name, &to](const std::string& given) { to = read_time(given, name); }, text)
        ->type_name("T");
  };
  time_option("--scan", run.scan, "the time from scan to scan (default: the program's, else 10ms)");
  time_option("--scan-delay", run.scan_delay, "the time from a scan until its outputs take effect (default: --scan)");
  time_option("--cycle", run.cycle, "with --link: length of a cycle (default: 10ms)");
  time_option("--window", options.setup.window,
              "what times of equal runs may differ by (default: 0s, with --link two cycles)");
  time_option("--limit", options.setup.limit, "plant time in which the base case must end (default: 10min)");
  command.add_option("--seed", run.seed, "seed of random times (default: 0)")->type_name("N");
}

}  // namespace

void add_campaign(CLI::App& app, Context& context) {
  auto options = std::make_shared<CampaignOptions>();
  options->fail_on.set(static_cast<std::size_t>(campaign::Class::violated));
  CLI::App* command = app.add_subcommand("campaign", "Run a PLC program with every single fault of the plant");
  CLI::Option* plant = command->add_option("PLANT", options->plant, "a plant.json or a symbol list");
  CLI::Option* base =
      command->add_option("--base", options->setup.scenario, "the base case: a scenario that passes without a fault")
          ->type_name("CASE");
  command
      ->add_option("--faults", options->faults,
                   "all (default): inputs stuck, loose and held, devices and tracks stuck and slow, controllers lost, "
                   "and the malfunctions of plant.json; or a file with a list of malfunctions, only for these")
      ->type_name("all|FILE");
  command
      ->add_option_function<std::string>(
          "--phases",
          [options](const std::string& text) {
            if (text != "start" && text != "all")
              throw CLI::ValidationError("--phases", "`" + text + "` is neither start nor all");
            options->phases = text == "all" ? campaign::Phases::all : campaign::Phases::start;
          },
          "start (default): each fault from the start; all: also from each change of its device or input in the base "
          "case")
      ->type_name("start|all");
  add_program_options(*command, *options);
  const BatchFlags batch = add_batch_options(*command, *options, "faults");
  batch.merge->excludes(plant)->excludes(base);
  for (const char* const of_a_run : {"--program", "--link", "--faults", "--phases"})
    batch.merge->excludes(command->get_option(of_a_run));
  command
      ->add_option_function<std::string>(
          "--fail-on", [options](const std::string& text) { options->fail_on = read_classes(text); },
          "classes that give exit code 1: violated (default), undetected, stopped, other, detected, no-effect, or none")
      ->type_name("CLASS,..");
  command->add_option("--csv", options->csv, "write a row for each fault, for spreadsheets")->type_name("FILE");
  add_plant_options(*command, options->plant_options);
  command->footer(
      "Exit codes: 0 no fault has a class of --fail-on; 1 one has, or a run has no result, or the base case does not "
      "pass; 2 bad input or usage; 3 environment.\n"
      "Examples:\n  symplant campaign plant.json --base cycle.json --program cell.so --html fmea.html\n"
      "  symplant campaign plant.json --base cycle.json --program cell.so --phases all --fail-on violated,undetected\n"
      "  symplant campaign plant.json --base cycle.json --program cell.so --shard 1/8 -o part1.jsonl\n"
      "  symplant campaign --merge part*.jsonl --csv fmea.csv --html fmea.html");
  command->callback([options, command, &context] {
    if (options->merged.empty() && (options->plant.empty() || options->setup.scenario.empty())) {
      return fail_batch(context, "give a PLANT and the base case with `--base CASE`, or `--merge FILE...`",
                        host::kBadInput);
    }
    options->setup.run.links = options->links;
    if (options->links.empty()) options->setup.run.clock = host::RunOptions::Clock::virtual_time;
    options->command = repeating_command(*command, *options);
    if (options->faults != "all") options->plant_options.malfunctions = options->faults;
    options->merged.empty() ? run_campaign(*options, context) : merge_campaign(*options, context);
  });
}

}  // namespace symplant::app

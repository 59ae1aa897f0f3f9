// symplant test: runs a suite of scenarios, and compares each with its reference trace.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "app/prepared_plant.hpp"
#include "app/progress.hpp"
#include "app/suite_command.hpp"
#include "batch/result_file.hpp"
#include "batch/workers.hpp"
#include "diag/visible_text.hpp"
#include "suite/plants.hpp"
#include "suite/report.hpp"
#include "suite/run_case.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/tables/nearest.hpp"
#include "symplant/trace/junit_xml.hpp"

namespace symplant::app {
namespace {

using suite::Speed;

/// The plants of a suite, by their speed.
class SuitePlants {
 public:
  SuitePlants(const PreparedPlant& prepared, const std::vector<Speed>& speeds) : prepared_(prepared) {
    for (const Speed speed : speeds) {
      Tables& tables = tables_[speed];
      tables.own = suite::at_speed(prepared.tables(), speed);
      tables.rows.emplace(tables.own.tables());
    }
  }
  host::PlantProgram at(Speed speed) const { return prepared_.program(*tables_.at(speed).rows); }

 private:
  struct Tables {
    lower::EngineTables own;
    std::optional<tables::PlantTables> rows;
  };
  const PreparedPlant& prepared_;
  std::map<Speed, Tables> tables_;
};

/// What the results may not replace.
std::vector<std::string> inputs_of(const suite::Suite& suite) {
  std::vector<std::string> inputs = {suite.folder + "/suite.json", suite.plant, suite.before};
  for (const std::string& name : suite.cases) {
    inputs.push_back(suite.scenario(name));
    for (const Speed speed : {Speed::normal, Speed::fast, Speed::slow}) inputs.push_back(suite.reference(name, speed));
  }
  return inputs;
}

/// Writes the reports. False, with a message and the exit code, if that fails.
bool write_reports(const TestOptions& options, const suite::Results& results, const suite::Counts& counts,
                   Context& context) {
  const std::string junit = options.junit.empty() ? "" : suite::junit_text(results, counts);
  if (!options.junit.empty() && !write_result(context, options.junit, base::whole(junit), {})) return false;
  const base::TextSource page = [&](base::TextSink& sink) { suite::write_html(results, counts, sink); };
  return options.html.empty() || write_result(context, options.html, page, {});
}

/// Sums up what there is.
void end_test(const TestOptions& options, const suite::Results& results, const suite::Counts& counts, bool complete,
              Context& context) {
  const std::string missing = suite::missing_text(results, counts);
  if (!missing.empty()) context.err << "error: " << missing << "\n";
  context.out << suite::summary(counts) << "\n";
  if (!write_reports(options, results, counts, context)) return;
  context.exit_code = counts.well() && complete ? host::kGood : host::kFindings;
}

class SuiteRun {
 public:
  SuiteRun(const TestOptions& options, const suite::Suite& suite, Context& context)
      : options_(options), suite_(suite), context_(context), progress_(context.err, context.progress) {
    for (const Speed speed : options.speeds) {
      for (const std::string& name : suite.cases) all_.push_back({&name, speed});
    }
    for (std::size_t number = 0; number < all_.size(); ++number) {
      if (options.shard.has(number)) mine_.push_back(number);
    }
  }

  void run(const PreparedPlant& prepared) {
    const SuitePlants plants(prepared, options_.speeds);
    const CaseFolder traces;
    std::string error = traces.error();
    suite::Results results({suite::kResultKey, suite_.folder, all_.size()}, options_.output, error);
    if (!error.empty()) return fail_batch(context_, error, host::kEnvironment);
    suite::Setup setup{suite_, {}, options_.update};
    setup.run.programs = options_.programs.empty() ? suite_.programs : options_.programs;
    setup.run.links = options_.links;
    if (options_.links.empty()) setup.run.clock = host::RunOptions::Clock::virtual_time;

    const auto work = [&](std::size_t piece) {
      const Case& one = all_[mine_[piece]];
      return suite::run_case(setup, plants.at(one.speed), *one.name, one.speed, traces.trace(piece)).line();
    };
    const auto done = [&](const batch::Done& piece) {
      std::string failed = results.add(mine_[piece.piece], result_of(piece));
      if (!failed.empty() && error.empty()) error = std::move(failed);
      show(results);
      progress_.stage(fmt::format("{} of {} cases", ++done_, mine_.size()));
    };
    host::catch_signals();
    const auto stop = [&] { return host::stop_requested().load() || !error.empty(); };
    const std::string failed = batch::do_in_processes(mine_.size(), jobs_of(options_), work, done, stop);
    progress_.clear();
    if (!failed.empty() && error.empty()) error = failed;
    if (!error.empty()) return fail_batch(context_, error, host::kEnvironment);
    const bool complete = !host::stop_requested().load();
    if (!complete) {
      counts_.missing = mine_.size() - (counts_.passed + counts_.failed + counts_.errors);
      context_.err << "warning: ended by a signal\n";
    }
    end_test(options_, results, counts_, complete, context_);
  }

 private:
  struct Case {
    const std::string* name;
    Speed speed;
  };

  suite::Result result_of(const batch::Done& piece) const {
    if (auto result = suite::Result::of_line(piece.answer)) return std::move(*result);
    const Case& one = all_[mine_[piece.piece]];
    suite::Result crashed;
    crashed.name = *one.name;
    crashed.speed = one.speed;
    crashed.messages = suite::message_lines(piece.words);
    return crashed;
  }

  /// Shows the results that are next in the order of the suite.
  void show(const suite::Results& results) {
    for (; shown_ < mine_.size() && results.has(mine_[shown_]); ++shown_) {
      const suite::Result result = results.read(mine_[shown_]);
      progress_.clear();
      suite::write_result(result, context_.out);
      context_.out.flush();
      counts_.add(result);
    }
  }

  const TestOptions& options_;
  const suite::Suite& suite_;
  Context& context_;
  std::vector<Case> all_;          ///< of the whole suite
  std::vector<std::size_t> mine_;  ///< those of this part
  std::size_t shown_ = 0;
  std::size_t done_ = 0;
  suite::Counts counts_;
  Progress progress_;
};

void merge(const TestOptions& options, Context& context) {
  if (!begin_reports(options, "symplant test", options.merged, context)) return;
  batch::Header header;
  std::string error = batch::read_results<suite::Result>(options.merged, suite::kResultKey, header,
                                                         [](std::size_t, const suite::Result&) { return ""; });
  if (!error.empty()) return fail_batch(context, error, host::kBadInput);
  suite::Results results(header, options.output, error);
  suite::Counts counts;
  const auto take = [&](std::size_t number, const suite::Result& result) { return results.add(number, result); };
  if (error.empty()) error = batch::read_results<suite::Result>(options.merged, suite::kResultKey, header, take);
  if (!error.empty()) return fail_batch(context, error, host::kEnvironment);
  for (std::size_t number = 0; number < header.count; ++number) {
    if (!results.has(number)) {
      ++counts.missing;
      continue;
    }
    const suite::Result result = results.read(number);
    if (result.verdict != suite::Result::Verdict::passed) suite::write_result(result, context.out);
    counts.add(result);
  }
  end_test(options, results, counts, true, context);
}

/// Leaves only the chosen cases, if some are. False, with a message, if one is unknown.
bool choose_cases(const std::vector<std::string>& chosen, suite::Suite& suite, Context& context) {
  if (chosen.empty()) return true;
  for (const std::string& name : chosen) {
    if (std::find(suite.cases.begin(), suite.cases.end(), name) != suite.cases.end()) continue;
    tables::NearestName nearest(name);
    for (const std::string& known : suite.cases) nearest.offer(known);
    const std::string hint =
        nearest.name().empty() ? "" : fmt::format("; did you mean `{}`?", diag::visible(std::string(nearest.name())));
    fail_batch(context, fmt::format("the suite has no case `{}`{}", diag::visible(name), hint), host::kBadInput);
    return false;
  }
  std::erase_if(suite.cases,
                [&](const std::string& name) { return std::find(chosen.begin(), chosen.end(), name) == chosen.end(); });
  return true;
}

void test(const TestOptions& options, Context& context) {
  if (!options.merged.empty()) return merge(options, context);
  if (options.folder.empty())
    return fail_batch(context, "give the folder of a suite, or `--merge FILE...`", host::kBadInput);
  const suite::ReadSuite read = suite::read_suite(options.folder);
  for (const std::string& fault : read.errors) context.err << diag::visible(fault) << "\n";
  for (const std::string& warning : read.warnings) context.err << "warning: " << diag::visible(warning) << "\n";
  if (!begin_reports(options, "symplant test",
                     read.suite ? inputs_of(*read.suite) : std::vector{options.folder + "/suite.json"}, context)) {
    return;
  }
  if (!read.suite) {
    context.exit_code = host::kBadInput;
    return;
  }
  suite::Suite suite = *read.suite;
  if (!choose_cases(options.cases, suite, context)) return;
  std::optional<Compiled> compiled = compile_for(context, read.suite->plant, options.plant);
  if (!compiled) return;
  const PreparedPlant prepared(std::move(*compiled), read.suite->plant);
  compiled.reset();
  if (options.base.empty()) {
    SuiteRun(options, suite, context).run(prepared);
  } else {
    propose_cases(options, *read.suite, prepared, context);
  }
}

void read_plants(const std::string& text, TestOptions& options) {
  options.speeds.clear();
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto speed = suite::speed_of(std::string_view(text).substr(begin, end - begin));
    if (!speed) throw CLI::ValidationError("--plants", "`" + text + "` is not a list of normal, fast, slow");
    if (std::find(options.speeds.begin(), options.speeds.end(), *speed) != options.speeds.end())
      throw CLI::ValidationError("--plants", "`" + text + "` names a plant twice");
    options.speeds.push_back(*speed);
    begin = end + 1;
  }
}

}  // namespace

void add_test(CLI::App& app, Context& context) {
  auto options = std::make_shared<TestOptions>();
  CLI::App* command = app.add_subcommand("test", "Run a suite of scenarios, and compare each with its reference trace");
  CLI::Option* folder =
      command->add_option("DIR", options->folder, "a folder with suite.json and a scenario for each case");
  CLI::Option* cases = command->add_option("--case", options->cases, "run this case only; may be repeated")
                           ->type_name("NAME")
                           ->allow_extra_args(false);
  command->add_option("--program", options->programs, "PLC programs instead of those of the suite; may be repeated")
      ->type_name("[CONTROLLER=]FILE")
      ->allow_extra_args(false);
  command->add_option("--link", options->links, "test the PLC at this link, in real time, one case at a time")
      ->type_name("[CONTROLLER=]URL")
      ->allow_extra_args(false);
  command
      ->add_option_function<std::string>(
          "--plants", [options](const std::string& text) { read_plants(text, *options); },
          "run each case on these plants: normal (default); fast: a fifth of the travel times; slow: three times the "
          "travel times")
      ->type_name("normal,fast,slow");
  CLI::Option* update = command->add_flag("--update", options->update, "write the reference traces of cases that pass");
  const BatchFlags batch = add_batch_options(*command, *options, "cases");
  batch.merge->excludes(update)->excludes(cases);
  CLI::Option* fresh =
      command->add_option("--new", options->folder, "propose cases for this suite instead of running it")
          ->type_name("DIR")
          ->excludes(folder)
          ->excludes(update)
          ->excludes(cases)
          ->excludes(batch.shard);
  CLI::Option* base = command->add_option("--base", options->base, "the case of the suite that all proposed cases vary")
                          ->type_name("CASE")
                          ->needs(fresh);
  fresh->needs(base);
  command->add_option("--most", options->most, "propose at most this number (default: 50)")
      ->type_name("N")
      ->check(CLI::Range(1, 100000))
      ->needs(fresh);
  add_plant_options(*command, options->plant);
  command->footer(
      "Exit codes: 0 all cases passed; 1 a case failed or could not run; 2 bad input or usage; 3 environment.\n"
      "Examples:\n  symplant test suite --program cell.so --junit report.xml --html report.html\n"
      "  symplant test suite --update\n  symplant test suite --plants normal,fast,slow\n"
      "  symplant test --new suite --base first_cycle\n  symplant test suite --shard 1/8 -o part1.jsonl\n  symplant "
      "test --merge part*.jsonl --junit report.xml");
  command->callback([options, &context] { test(*options, context); });
}

}  // namespace symplant::app

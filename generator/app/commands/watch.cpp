// symplant watch: what a real plant does that its model does not expect.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "app/recording_options.hpp"
#include "app/watch_live.hpp"
#include "app/watch_output.hpp"
#include "compare/difference.hpp"
#include "diag/visible_text.hpp"
#include "observe/matched.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/tables/duration.hpp"
#include "symplant/trace/words.hpp"
#include "watch/shadow.hpp"
#include "watch/statistics.hpp"
#include "watch/words.hpp"

namespace symplant::app {
namespace {

struct WatchOptions {
  std::string plant;
  PlantOptions plant_options;
  std::string trace;
  RecordingOptions recording;
  std::string learned;
  LiveOptions live;
  bool has_every = false;
  WatchFiles files;
};

/// What is watched, kept until the program ends.
struct WatchedPlant {
  Compiled compiled;
  recording::Recording recording;
  std::vector<watch::Statistic> statistics;
};

bool fail_watch(Context& context, const std::string& message, int code = host::kBadInput) {
  context.err << "error: " << diag::visible(message) << "\n";
  context.exit_code = code;
  return false;
}

/// Whether it is a recording that is watched, or a link. False, with a message and the exit code, unless it is one.
bool has_one_source(const WatchOptions& options, Context& context) {
  if (options.trace.empty() == options.live.links.empty()) {
    return fail_watch(context, options.trace.empty() ? "nothing to watch: give a TRACE, or `--link URL`"
                                                     : "a TRACE and `--link` are given: give one of them");
  }
  const bool has_recording_option = !options.recording.rename_file.empty() || !options.recording.time_column.empty() ||
                                    !options.recording.time_unit.empty();
  if (options.trace.empty() && has_recording_option) {
    return fail_watch(context,
                      "`--rename`, `--time-column` and `--time-unit` are for a TRACE: leave them out with `--link`");
  }
  if (!options.trace.empty() && (options.has_every || options.live.until)) {
    return fail_watch(context, "`--every` and `--until` are for `--link`: leave them out with a TRACE");
  }
  return true;
}

/// The statistics of --learned. False, with a message and the exit code, if they cannot be read.
bool read_learned(const WatchOptions& options, WatchedPlant& watched, Context& context) {
  if (options.learned.empty()) return true;
  auto bytes = context.files.read(options.learned);
  if (!bytes) return fail_watch(context, bytes.error().message);
  watch::ReadStatistics read = watch::read_statistics(*bytes, options.learned, watched.compiled.plant);
  if (!read.error.empty()) return fail_watch(context, read.error);
  watched.statistics = std::move(read.statistics);
  return true;
}

/// Reports what of the recording is no symbol. False if nothing is.
bool report_unknown(const WatchOptions& options, const observe::Matched& matched, Context& context) {
  const std::string stranger = no_symbol_error(options.trace, options.plant, matched);
  if (!stranger.empty()) return fail_watch(context, stranger);
  if (matched.unknown.empty()) return true;
  const bool one = matched.unknown.size() == 1;
  context.err << diag::visible(fmt::format("warning: {} {} of `{}` {} left out: {}", matched.unknown.size(),
                                           one ? "name" : "names", options.trace,
                                           one ? "is not a symbol, and is" : "are not symbols, and are",
                                           unknown_names(matched)))
              << "\n";
  return true;
}

void watch_plant(const WatchOptions& options, Context& context) {
  if (!has_one_source(options, context)) return;
  if (!options.learned.empty()) {
    if (const auto learned = context.files.read(options.learned); !learned) {
      fail_watch(context, learned.error().message);
      return;
    }
  }
  PlantOptions plant_options = options.plant_options;
  plant_options.times = options.learned;
  auto compiled = compile_for(context, options.plant, plant_options);
  if (!compiled) return;
  const auto watched = std::make_shared<WatchedPlant>(WatchedPlant{std::move(*compiled), {}, {}});
  context.kept = watched;
  const model::PlantModel& plant = watched->compiled.plant;
  if (!read_learned(options, *watched, context)) return;
  std::vector<std::string> inputs = plant.input_files();
  inputs.insert(inputs.end(), {options.trace, options.learned, options.recording.rename_file});
  if (options.trace.empty()) {
    watch_live(watched->compiled, watched->statistics, options.live, options.files, inputs, context);
    return;
  }
  auto recording = read_recording_file(options.trace, options.recording, context);
  if (!recording) return;
  watched->recording = std::move(*recording);
  const observe::Matched matched = observe::adopt(plant, watched->recording);
  if (!report_unknown(options, matched, context)) return;

  const watch::Margin margin{options.live.margin, watched->recording.resolution};
  WatchOutput output(plant, margin, options.files, context);
  if (!output.open(inputs)) return;
  output.begin(watched->recording.name, watched->recording.end, matched.recorded);
  watch::Shadow shadow(plant, matched.recorded, margin, watched->statistics,
                       [&](const watch::Anomaly& anomaly) { output.add(anomaly); });
  watch::follow(watched->recording, matched, shadow);
  output.end(shadow.counts(), watched->recording.end, inputs);
}

void read_margin(const std::string& text, WatchOptions& options) {
  const auto share = compare::parse_tolerance(text);
  if (!share) {
    throw CLI::ValidationError("--margin", "`" + text + "` is not a share: write a number and %, such as 20%");
  }
  options.live.margin = *share;
}

/// An option with a duration from `least` to an hour times 10,000.
template <class Value>
void add_live_time(CLI::App& command, const std::string& name, Value& value, tables::Time least,
                   const std::string& least_text, const std::string& text) {
  constexpr tables::Time kMost = 10'000 * 3600 * tables::kSecond;
  const auto take = [name, &value, least, least_text](const std::string& given) {
    const auto time = tables::parse_duration(given);
    if (!time || *time < least || *time > kMost) {
      throw CLI::ValidationError(
          name, "`" + given + "` is out of range: write a time from " + least_text + " to 10000h, such as 50ms");
    }
    value = *time;
  };
  command.add_option_function<std::string>(name, take, text)->type_name("T");
}

}  // namespace

void add_watch(CLI::App& app, Context& context) {
  auto options = std::make_shared<WatchOptions>();
  CLI::App* command = app.add_subcommand("watch", "Find what a real plant does that its model does not expect");
  command->add_option("PLANT", options->plant, "a plant.json, or a symbol list")->required();
  command->add_option("TRACE", options->trace, "a recording of the plant, or a trace");
  add_plant_options(*command, options->plant_options);
  add_recording_options(*command, options->recording);
  command
      ->add_option("--learned", options->learned, "the times that `symplant learn -o` wrote; they replace the plant's")
      ->type_name("FILE");
  command
      ->add_option_function<std::string>(
          "--margin", [options](const std::string& text) { read_margin(text, *options); },
          "how much longer or shorter than the model allows a move may be, as a share of the longest time (default: "
          "20%); at least two resolutions of the recording")
      ->type_name("P%");
  command
      ->add_option("--link", options->live.links,
                   "watch a PLC instead, reading only: modbus-tcp://HOST:PORT, slmp://HOST:PORT?family=q or "
                   "opc-ua://HOST:PORT?nodes=TEMPLATE")
      ->type_name("[CONTROLLER=]URL")
      ->allow_extra_args(false);
  add_live_time(*command, "--every", options->live.every, tables::kMillisecond, "1ms",
                "with --link: from one reading to the next (default: 50ms)");
  add_live_time(*command, "--until", options->live.until, 1, "1ns",
                "with --link: how long to watch (default: until Ctrl-C)");
  command->add_option("--findings", options->files.findings, "write each anomaly to this file, as JSON lines")
      ->type_name("FILE");
  command
      ->add_option("--junit", options->files.junit,
                   "write JUnit XML to this file: a test case for each device that moved")
      ->type_name("FILE");
  command->footer(
      "Exit codes: 0 no anomaly; 1 anomalies; 2 bad input or usage; 3 a file cannot be written, or the PLC not read.\n"
      "Examples:\n  symplant watch plant.json line2.jsonl --learned learned.json --findings anomalies.jsonl\n"
      "  symplant watch symbols.csv scope.csv --rename names.csv --margin 30% --junit watch.xml\n"
      "  symplant watch plant.json --link modbus-tcp://192.168.0.10:502 --findings anomalies.jsonl");
  command->callback([options, command, &context] {
    options->has_every = command->count("--every") != 0;
    watch_plant(*options, context);
  });
}

}  // namespace symplant::app

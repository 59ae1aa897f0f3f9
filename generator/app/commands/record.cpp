// symplant record: records a real plant, without writing to its PLC.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <ostream>
#include <system_error>
#include <thread>
#include <utility>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "app/read_link.hpp"
#include "diag/visible_text.hpp"
#include "record/recorder.hpp"
#include "symplant/host/console.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/files_apart.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/host/words.hpp"
#include "symplant/link/choice.hpp"
#include "symplant/link/client_parts.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/tables/duration.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::app {
namespace {

using record::RecordState;
using tables::Time;

constexpr Time kShortestInterval = tables::kMillisecond;
constexpr Time kLongestInterval = 3600 * tables::kSecond;
constexpr Time kLongestBefore = 24 * 3600 * tables::kSecond;
constexpr Time kLatestEnd = 876'000 * (3600 * tables::kSecond);
constexpr std::uint64_t kSmallestLimit = 1024;
/// With --until: how long a PLC is waited for at least, as in `run`.
constexpr Time kPatience = 5 * tables::kSecond;
constexpr auto kLook = std::chrono::milliseconds(20);
constexpr auto kLinePeriod = std::chrono::seconds(1);

struct RecordOptions {
  std::string plant;
  PlantOptions plant_options;
  std::vector<std::string> links;
  std::string output;
  Time every = 50 * tables::kMillisecond;
  std::optional<Time> until;
  Time before = 0;
  std::string start;
  std::string stop;
  std::uint64_t limit = trace::kNoLimit;

  bool to_standard_output() const { return output.empty() || host::is_standard_output(output); }
};

using link::LinkError;

LinkError usage(std::string message) { return {LinkError::Kind::usage, std::move(message)}; }

/// A time of the steady clock as a time of day.
std::string utc_of(Time steady) {
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::nanoseconds ago = now.time_since_epoch() - std::chrono::nanoseconds(steady);
  const auto time = std::chrono::time_point_cast<std::chrono::microseconds>(
      std::chrono::system_clock::now() - std::chrono::duration_cast<std::chrono::system_clock::duration>(ago));
  const auto second = std::chrono::floor<std::chrono::seconds>(time);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:06}Z", fmt::gmtime(std::chrono::system_clock::to_time_t(second)),
                     (time - second).count());
}

std::string tenths(Time time) { return fmt::format("{:.1f} s", static_cast<double>(time) / 1e9); }
std::string milliseconds(Time time) { return fmt::format("{:.1f} ms", static_cast<double>(time) / 1e6); }

std::string gaps_text(const RecordState& state) {
  return state.gaps == 0 ? "no gaps"
                         : fmt::format("{}, {} in total", host::plural(state.gaps, "gap"), tenths(state.gap_time));
}

std::string state_text(const RecordState& state) {
  if (!state.has_images) return "waiting for the PLC";
  const char* const lost = state.is_lost ? "; no connection" : "";
  if (!state.has_started) return std::string("waiting for the start condition") + lost;
  return fmt::format("{}, {} of {}, {}{}", tenths(state.length), host::plural(state.changes, "change"),
                     host::plural(state.symbols, "symbol"), gaps_text(state), lost);
}

/// What was recorded, and how well.
std::string summary_text(const RecordState& state, const link::record::LoopMeter& meter, Time every) {
  const exec::Durations intervals = meter.intervals.durations();
  std::string text =
      fmt::format("recorded {}: {} of {}, {}\n", tenths(state.length), host::plural(state.changes, "change"),
                  host::plural(state.symbols, "symbol"), gaps_text(state));
  if (state.kept != 0) text += fmt::format("the start condition held at {}\n", trace::seconds(state.kept));
  if (intervals.count == 0) return text;
  text += fmt::format("reading interval: median {}, longest {}; {} of {} began late, {} incomplete\n",
                      milliseconds(intervals.p50), milliseconds(intervals.max), meter.late.value(),
                      host::plural(meter.images.value(), "image"), meter.incomplete.value());
  text += fmt::format("resolution: {}{}\n", milliseconds(state.resolution),
                      state.resolution > every
                          ? ", since the PLC answers too slowly for `--every " + tables::duration_text(every) + "`"
                          : std::string());
  return text;
}

/// Waits for the end of a recording, and shows how far it is.
void attend(record::Recorder& recorder, const RecordOptions& options, host::Console& console, bool draws) {
  const auto begin = std::chrono::steady_clock::now();
  auto next_line = begin + kLinePeriod;
  const std::chrono::nanoseconds patience(std::max(options.until.value_or(0), kPatience));
  const auto report = [&] {
    for (const std::string& message : recorder.take_messages())
      console.message(diag::visible("link: " + message) + "\n");
  };
  while (!recorder.has_ended() && !host::stop_requested().load()) {
    std::this_thread::sleep_for(kLook);
    report();
    const auto now = std::chrono::steady_clock::now();
    const RecordState state = recorder.state();
    if (options.until && !state.has_images && now - begin > patience) break;
    if (!draws || now < next_line) continue;
    next_line = now + kLinePeriod;
    console.draw(state_text(state));
  }
  recorder.stop();
  report();
  console.clear();
}

/// The exit code, with its message.
int conclude(const record::Writer& writer, const RecordOptions& options, std::ostream& err) {
  const RecordState& state = writer.state();
  if (!writer.error().empty()) {
    err << fmt::format("error: {}; the recording ends at {}, what was written before is valid\n",
                       diag::visible(writer.error()), trace::seconds(state.length));
    return host::kEnvironment;
  }
  if (!state.has_images) {
    err << "error: nothing was recorded: there was no complete reading of the PLC; `symplant doctor` examines the "
           "link\n";
    return host::kEnvironment;
  }
  if (state.has_started) return host::kGood;
  err << fmt::format("error: nothing was recorded: `--start-when {}` did not hold\n", diag::visible(options.start));
  return host::kFindings;
}

/// Reads a condition of the command line; nothing, with a message, if it is wrong.
bool read_condition(const char* option, const std::string& text, const trace::PlantNames& names,
                    const std::vector<bool>& is_read, std::optional<record::Trigger>& trigger, std::ostream& err) {
  if (text.empty()) return true;
  auto read = record::read_trigger(text, names, is_read);
  if (const auto* fault = std::get_if<std::string>(&read)) {
    err << "error: " << option << " " << diag::visible(*fault) << "\n";
    return false;
  }
  trigger = std::get<record::Trigger>(std::move(read));
  return true;
}

bool overwrites_input(Context& context, const RecordOptions& options, const std::vector<std::string>& inputs) {
  if (options.to_standard_output()) return false;
  if (overwrites(context, options.output, inputs)) return true;
  return options.limit != trace::kNoLimit && overwrites(context, options.output + ".1", inputs);
}

/// Records the link of `parts`; returns the exit code.
int record_parts(link::client::ClientParts& parts, record::What what, const trace::PlantNames& names,
                 const RecordOptions& options, Context& context) {
  if (std::string text = link::client::unreachable_text(parts.unreachable, names.tables()); !text.empty()) {
    context.err << "warning: " << diag::visible(text) << "\n";
  }
  trace::OutputFile file = options.to_standard_output() ? trace::OutputFile("recording", context.out)
                                                        : trace::OutputFile("recording", options.output, options.limit,
                                                                            trace::OutputFile::Old::kept);
  if (!file.error().empty()) {
    context.err << "error: " << diag::visible(file.error()) << "\n";
    return host::kEnvironment;
  }
  host::catch_signals();
  record::Writer writer(std::move(file), names, std::move(what));
  host::Console console(context.err, context.err);
  record::Recorder recorder(parts, names.tables(), options.every, writer);
  attend(recorder, options, console, context.progress);
  if (writer.state().has_started) context.err << summary_text(writer.state(), recorder.meter(), options.every);
  return conclude(writer, options, context.err);
}

void record_plant(const RecordOptions& options, Context& context) {
  auto made = compile_for(context, options.plant, options.plant_options);
  if (!made) return;
  const auto compiled = std::make_shared<const Compiled>(std::move(*made));
  context.kept = compiled;
  if (overwrites_input(context, options, compiled->plant.input_files())) return;
  const tables::PlantTables tables = compiled->tables.tables();
  const auto fail = [&](const LinkError& error) {
    context.err << "error: " << diag::visible(error.message) << "\n";
    context.exit_code = error.kind == LinkError::Kind::usage ? host::kBadInput : host::kEnvironment;
  };
  const auto chosen = link_to_read("record", options.links, compiled->plant, tables);
  if (const auto* error = std::get_if<LinkError>(&chosen)) return fail(*error);
  const auto& choice = std::get<link::LinkChoice>(chosen);
  auto opened = link::client_parts(choice, tables);
  if (const auto* error = std::get_if<LinkError>(&opened)) return fail(*error);
  auto& parts = std::get<link::client::ClientParts>(opened);
  if (parts.map.points.empty())
    return fail(usage("this link carries no symbol of the plant: check the addresses of the list, and `--link`"));
  std::vector<bool> is_read(tables.symbols.size());
  for (const link::image::Point& point : parts.map.points) is_read[point.symbol] = true;
  const trace::PlantNames names(tables);
  record::What what{.link = choice.url,
                    .every = options.every,
                    .until = options.until,
                    .start = {},
                    .stop = {},
                    .before = options.before,
                    .model_hash = tables::model_hash(tables),
                    .utc = utc_of};
  if (!read_condition("--start-when", options.start, names, is_read, what.start, context.err) ||
      !read_condition("--stop-when", options.stop, names, is_read, what.stop, context.err)) {
    context.exit_code = host::kBadInput;
    return;
  }
  try {
    context.exit_code = record_parts(parts, std::move(what), names, options, context);
  } catch (const std::system_error& error) {
    fail({LinkError::Kind::environment, std::string("cannot start a thread: ") + error.what()});
  }
}

/// An option with a duration from `least` to `most`; `allowed` names these.
CLI::Option* add_time(CLI::App& command, const std::string& name, std::function<void(Time)> set, Time least, Time most,
                      const std::string& allowed, const std::string& text) {
  const auto take = [name, set = std::move(set), least, most, allowed](const std::string& given) {
    const auto time = tables::parse_duration(given);
    if (!time || *time < least || *time > most) {
      throw CLI::ValidationError(name, "`" + given + "` is out of range: write a time " + allowed);
    }
    set(*time);
  };
  return command.add_option_function<std::string>(name, take, text)->type_name("T");
}

void add_times(CLI::App& command, RecordOptions& options) {
  add_time(
      command, "--every", [&options](Time time) { options.every = time; }, kShortestInterval, kLongestInterval,
      "from 1ms to 1h, such as 50ms", "from one reading to the next, the resolution of the recording (default: 50ms)");
  add_time(
      command, "--until", [&options](Time time) { options.until = time; }, 1, kLatestEnd,
      "above 0 and at most 876000h, such as 10min",
      "the length of the recording from its start (default: until Ctrl-C); a PLC that does not answer is waited for as "
      "long, but at least 5 s");
}

void add_triggers(CLI::App& command, RecordOptions& options) {
  CLI::Option* const start =
      command
          .add_option(
              "--start-when", options.start,
              "start when this condition of symbols holds, such as `LINE_S1_CYL_O_OUT and not LINE_S1_CYL_I_OUT`")
          ->type_name("COND");
  command.add_option("--stop-when", options.stop, "stop when this condition of symbols holds after the start")
      ->type_name("COND");
  add_time(
      command, "--before", [&options](Time time) { options.before = time; }, 1, kLongestBefore,
      "above 0 and at most 24h, such as 10s",
      "with --start-when: begin the file this long before the condition held (default: 0s)")
      ->needs(start);
}

void add_output(CLI::App& command, RecordOptions& options) {
  CLI::Option* const output =
      command.add_option("-o,--output", options.output, "write the recording to this file (default: standard output)")
          ->type_name("FILE");
  command
      .add_option_function<std::string>(
          "--trace-limit",
          [&options](const std::string& text) {
            const auto size = host::parse_size(text);
            if (!size || *size < kSmallestLimit) {
              throw CLI::ValidationError("--trace-limit",
                                         "`" + text + "` is not a size of 1k or more: write bytes, or 500k, 10M, 1G");
            }
            options.limit = *size;
          },
          "rename a file of this size to FILE.1 and start a new one; 1k or more (default: no limit)")
      ->type_name("SIZE")
      ->needs(output);
}

}  // namespace

void add_record(CLI::App& app, Context& context) {
  auto options = std::make_shared<RecordOptions>();
  CLI::App* command =
      app.add_subcommand("record", "Record a real plant: reads its PLC at a fixed interval, writes nothing to it");
  command->add_option("PLANT", options->plant, "a plant.json or a symbol list")->required();
  command
      ->add_option("--link", options->links,
                   "the PLC: modbus-tcp://HOST:PORT, slmp://HOST:PORT?family=q or opc-ua://HOST:PORT?nodes=TEMPLATE "
                   "(default: the plant's own link)")
      ->type_name("[CONTROLLER=]URL")
      ->allow_extra_args(false);
  add_output(*command, *options);
  add_times(*command, *options);
  add_triggers(*command, *options);
  add_plant_options(*command, options->plant_options);
  command->footer(
      "Exit codes: 0 recorded; 1 the start condition did not hold; 2 bad input; 3 no reading of the PLC, or the file "
      "cannot be written.\nExamples:\n"
      "  symplant record plant.json --link modbus-tcp://192.168.0.10:502 -o line2.jsonl\n"
      "  symplant record plant.json --link \"slmp://192.168.3.39:5000?family=q\" -o line2.jsonl --until 8h\n"
      "  symplant record plant.json -o fault.jsonl --start-when LINE_S1_CYL_I_ALARM --before 30s --until 10s");
  command->callback([options, &context] { record_plant(*options, context); });
}

}  // namespace symplant::app

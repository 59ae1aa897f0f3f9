// symplant show: shows a trace file in the panel's page, without a running plant.
#include "symplant/panel/show.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fstream>
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "app/panel_view.hpp"
#include "app/recording_options.hpp"
#include "app/stream_sink.hpp"
#include "observe/play.hpp"
#include "recording/write_json_lines.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/host/run_options.hpp"
#include "symplant/host/signals.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/trace/finding_words.hpp"

namespace symplant::app {
namespace {

struct ShowOptions {
  std::string trace;
  std::string plant;
  RecordingOptions recordings;
  PlantOptions plant_options;
  host::RunOptions panel;
};

/// Reports what of the trace is not shown. False if it cannot be shown at all; then the exit code is set.
bool is_of_plant(Context& context, const ShowOptions& options, const trace::ReadTrace& trace,
                 std::uint64_t model_hash) {
  const auto fail = [&](const std::string& message) {
    context.err << "error: " << message << "\n";
    context.exit_code = host::kBadInput;
    return false;
  };
  if (!trace.error.empty()) return fail(fmt::format("{}: {}", options.trace, trace.error));
  if (trace.records.empty() && trace.unknown != 0) {
    return fail(fmt::format("`{}` is of another plant: it has no symbol of this one, such as `{}`", options.trace,
                            trace.first_unknown));
  }
  if (trace.model_hash != fmt::format("{:016x}", model_hash)) {
    context.err << fmt::format("warning: `{}` is of another model: its model_hash is {}, that of this plant {:016x}\n",
                               options.trace, trace.model_hash, model_hash);
  }
  if (trace.cut_off) {
    context.err << fmt::format("warning: {}: the last line is cut off, and is left out\n", options.trace);
  }
  if (trace.unknown != 0) {
    context.err << fmt::format("warning: {} lines are left out: the plant has no `{}`\n", trace.unknown,
                               trace.first_unknown);
  }
  if (trace.set_back != 0) {
    context.err << fmt::format("note: the plant was reset or restored {} times; shown is what follows the last time\n",
                               trace.set_back);
  }
  return true;
}

bool is_trace(const std::string& path) {
  constexpr std::string_view kBegin = R"({"symplant-trace":)";
  std::string begin(kBegin.size(), '\0');
  std::ifstream(path).read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin == kBegin;
}

/// A file of another format as a trace; nothing, with a message and the exit code, if it cannot be read.
std::optional<trace::ReadTrace> converted(const ShowOptions& options, const model::PlantModel& plant,
                                          const trace::PlantNames& names, std::uint64_t model_hash, Context& context) {
  auto recording = read_recording_file(options.trace, options.recordings, context);
  if (!recording) return std::nullopt;
  observe::adopt(plant, *recording);
  std::stringstream lines;
  StreamSink sink(lines);
  recording::write_json_lines(*recording, sink);
  trace::ReadTrace trace = trace::read_trace(lines, names);
  trace.model_hash = fmt::format("{:016x}", model_hash);  // a recording is of no model
  return trace;
}

std::optional<trace::ReadTrace> read_shown(const ShowOptions& options, const model::PlantModel& plant,
                                           const trace::PlantNames& names, std::uint64_t model_hash, Context& context) {
  const bool is_as_it_is = is_trace(options.trace) && options.recordings.rename_file.empty();
  if (!is_as_it_is) return converted(options, plant, names, model_hash, context);
  std::ifstream file(options.trace);
  return trace::read_trace(file, names);
}

void show(ShowOptions options, Context& context) {
  if (is_trace(options.plant) && !is_trace(options.trace)) std::swap(options.plant, options.trace);
  auto compiled = compile_for(context, options.plant, options.plant_options);
  if (!compiled) return;
  const tables::PlantTables tables = compiled->tables.tables();
  const trace::PlantNames names(tables);
  const std::uint64_t model_hash = tables::model_hash(tables);
  std::optional<trace::ReadTrace> trace = read_shown(options, compiled->plant, names, model_hash, context);
  if (!trace || !is_of_plant(context, options, *trace, model_hash)) return;
  const tables::Time length = trace->end - trace->begin;
  const PanelView view(compiled->plant, options.plant);
  host::catch_signals();
  const auto begun = [&](const std::string& link) {
    context.out << fmt::format("{}: {} of plant time; Ctrl-C ends\npanel: {}\n", options.trace, trace::seconds(length),
                               link);
    context.out.flush();
  };
  const auto error = panel::show(
      options.panel.panel.value_or(panel::PanelOptions{}), std::move(*trace), names, view.view(), model_hash, begun,
      [] { return host::stop_requested().load(); },
      [&](const std::string& message) { context.err << "warning: " + message + "\n"; });
  if (!error) return;
  context.err << "error: panel: " << error->message << "\n";
  context.exit_code = error->kind == link::LinkError::Kind::usage ? host::kBadInput : host::kEnvironment;
}

}  // namespace

void add_show(CLI::App& app, Context& context) {
  auto options = std::make_shared<ShowOptions>();
  CLI::App* command = app.add_subcommand("show", "Show a trace file in the browser, without a running plant");
  command
      ->add_option(
          "TRACE", options->trace,
          "a file that `run --trace` wrote, a VCD file of a run or a recording as CSV; a trace may also follow PLANT")
      ->required();
  command->add_option("PLANT", options->plant, "the plant.json or symbol list of its plant")->required();
  host::add_address_options(*command, options->panel, "play the trace");
  add_recording_options(*command, options->recordings);
  add_plant_options(*command, options->plant_options);
  command->footer(
      "Examples:\n  symplant show trace.jsonl plant.json\n  symplant show trace.jsonl plant.json --panel 8200");
  command->callback([options, &context] { show(*options, context); });
}

}  // namespace symplant::app

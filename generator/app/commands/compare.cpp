// symplant compare: how one recorded run differs from another, or from the run of a plant.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/commands/compare_sessions.hpp"
#include "app/options.hpp"
#include "app/recording_options.hpp"
#include "compare/difference.hpp"
#include "compare/formats.hpp"
#include "compare/words.hpp"
#include "diag/visible_text.hpp"
#include "observe/matched.hpp"
#include "recording/write_json_lines.hpp"
#include "study/formats.hpp"
#include "study/study.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/tables/digest.hpp"
#include "symplant/tables/duration.hpp"

namespace symplant::app {
namespace {

struct CompareOptions {
  std::string expected;
  std::string actual;  ///< empty: the run of `plant`
  std::string plant;
  PlantOptions plant_options;
  RecordingOptions recordings;
  compare::Options how;
  std::string format = "text";
  std::string output;
  std::string html;  ///< a file; empty: `format` and `output` count
};

/// What is compared, kept until the program ends.
struct ComparedTraces {
  recording::Recording expected;
  recording::Recording actual;
  compare::Comparison comparison;
  std::optional<study::Study> study;  ///< of the run of a plant, which is `actual`
};

struct CompareFormat {
  const char* name;
  void (*write)(const compare::Comparison&, base::TextSink&);
  void (*write_study)(const study::Study&, const compare::Comparison&, base::TextSink&);
};
constexpr std::array<CompareFormat, 4> kCompareFormats{
    {{"text", compare::write_text, study::write_text},
     {"json", compare::write_json, study::write_json},
     {"junit", compare::write_junit,
      [](const study::Study&, const compare::Comparison& comparison, base::TextSink& sink) {
        compare::write_junit(comparison, sink);
      }},
     {"html", compare::write_html, study::write_html}}};

/// Of which kind the series of a file without types are follows from the other one.
void settle_kinds(recording::Recording& recording, const recording::Recording& other) {
  recording::settle_kinds(recording, [&](const std::string& symbol) -> std::optional<recording::Series::Kind> {
    const auto found = other.index.find(symbol);
    return found == other.index.end() ? std::nullopt : std::optional(other.series[found->second].kind);
  });
}

/// Writes what was compared, and sets the exit code.
void report(const CompareOptions& options, const ComparedTraces& compared, Context& context) {
  const compare::Comparison& comparison = compared.comparison;
  if (!comparison.error.empty()) {
    context.err << "error: " << diag::visible(comparison.error) << "\n";
    context.exit_code = host::kBadInput;
    return;
  }
  if (!comparison.warning.empty()) context.err << "warning: " << diag::visible(comparison.warning) << "\n";
  const auto format = std::find_if(kCompareFormats.begin(), kCompareFormats.end(),
                                   [&](const CompareFormat& one) { return options.format == one.name; });
  const base::TextSource text = [&](base::TextSink& sink) {
    compared.study ? format->write_study(*compared.study, comparison, sink) : format->write(comparison, sink);
  };
  std::vector<std::string> inputs{options.expected};
  if (!options.actual.empty()) inputs.push_back(options.actual);
  if (!options.plant.empty()) inputs.push_back(options.plant);
  if (!write_result(context, options.output, text, inputs)) return;
  if (!options.output.empty()) context.out << diag::visible(compare::summary(comparison)) << "\n";
  if (!comparison.differences.empty()) context.exit_code = host::kFindings;
}

/// Reports whose trace it is, if it is not that of the plant. False, with the exit code, if nothing can be compared.
bool is_of_plant(const CompareOptions& options, const recording::Recording& recorded, const Compiled& compiled,
                 Context& context) {
  const observe::Matched matched = observe::match(compiled.plant, recorded);
  const bool other = !recorded.plant.empty() && recorded.plant != compiled.plant.name &&
                     recorded.model_hash != fmt::format("{:016x}", tables::model_hash(compiled.tables.tables()));
  const std::string of_other = other ? fmt::format("`{}` is a trace of another plant: of `{}`, not of `{}`",
                                                   options.expected, recorded.plant, compiled.plant.name)
                                     : std::string();
  if (matched.has_symbols() || (recorded.of_plant && !other && matched.unknown.empty())) {
    if (other && recorded.of_plant) context.err << "warning: " << diag::visible(of_other) << "\n";
    return true;
  }
  const std::string message = matched.unknown.empty() ? fmt::format("`{}` has no change of a symbol", options.expected)
                                                      : no_symbol_error(options.expected, options.plant, matched);
  context.err << "error: " << diag::visible((other ? of_other + "; " : "") + message) << "\n";
  context.exit_code = host::kBadInput;
  return false;
}

/// The run of the plant with the operations of the recording, which gets the types of the plant; nothing, with the exit
/// code, if it cannot run.
std::optional<study::Study> study_of(const CompareOptions& options, recording::Recording& recorded, Context& context) {
  const auto compiled = compile_for(context, options.plant, options.plant_options);
  if (!compiled) return std::nullopt;
  if (!is_of_plant(options, recorded, *compiled, context)) return std::nullopt;
  observe::adopt(compiled->plant, recorded);
  study::Study study =
      study::study(compiled->plant, compiled->tables.tables(), recorded, options.plant,
                   [&](std::string_view name) { return compare::is_chosen(options.how, std::string(name)); });
  constexpr std::size_t kMostNames = 20;
  for (std::size_t i = 0; i < std::min(kMostNames, study.unmatched.size()); ++i) {
    context.err << "warning: no symbol of " << diag::visible(options.plant) << " has the name "
                << diag::visible(study.unmatched[i]) << "\n";
  }
  if (study.unmatched.size() > kMostNames) {
    context.err << "warning: ... and " << study.unmatched.size() - kMostNames << " other names\n";
  }
  return study;
}

/// Sessions at the panel have no symbols, and two formats.
void compare_sessions(const CompareOptions& options, Context& context) {
  const bool as_page = options.format == "html";
  if (options.actual.empty() || (!as_page && options.format != "text")) {
    context.err << (options.actual.empty()
                        ? "error: give the session of the expert, then that of the trainee\n"
                        : "error: the comparison of two sessions is a text, or with `--html FILE` a page\n");
    context.exit_code = host::kBadInput;
    return;
  }
  compare_session_files(options.expected, options.actual, as_page, options.output, context);
}

void compare_traces(const CompareOptions& options, Context& context) {
  if (options.actual.empty() == options.plant.empty()) {
    context.err << (options.plant.empty() ? "error: give the second trace, or a plant to run with `--plant`\n"
                                          : "error: `--plant` replaces the second trace: give one of them\n");
    context.exit_code = host::kBadInput;
    return;
  }
  std::vector<std::string> paths{options.expected};
  if (options.plant.empty()) paths.push_back(options.actual);
  auto recordings = read_recording_files(paths, options.recordings, context);
  if (!recordings) return;
  const auto compared = std::make_shared<ComparedTraces>();
  context.kept = compared;
  compared->expected = std::move(recordings->front());
  if (options.plant.empty()) {
    compared->actual = std::move(recordings->back());
    settle_kinds(compared->expected, compared->actual);
    settle_kinds(compared->actual, compared->expected);
  } else {
    compared->study = study_of(options, compared->expected, context);
    if (!compared->study) return;
    compared->actual = std::move(compared->study->run);
  }
  compared->comparison = compare::compare(compared->expected, compared->actual, options.how);
  report(options, *compared, context);
}

void read_window(const std::string& text, CompareOptions& options) {
  options.how.window = tables::parse_duration(text);
  if (!options.how.window) {
    throw CLI::ValidationError(
        "--window", "`" + text + "` is not a duration: write a number and ns, us, ms, s, min or h, such as 30ms");
  }
}

void read_tolerance(const std::string& text, CompareOptions& options) {
  const auto tolerance = compare::parse_tolerance(text);
  if (!tolerance) {
    throw CLI::ValidationError("--tolerance", "`" + text + "` is not a share: write a number and %, such as 2.5%");
  }
  options.how.tolerance = *tolerance;
}

void read_align(const std::string& text, CompareOptions& options) {
  options.how.align_symbol.clear();
  options.how.align = compare::align_of(text);
  if (options.how.align == compare::Align::symbol) options.how.align_symbol = text;
}

}  // namespace

void add_compare(CLI::App& app, Context& context) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand(
      "compare", "Compare two traces, a recording with the run of a plant, or two sessions at the panel");
  command
      ->add_option("EXPECTED", options->expected,
                   "the trace of a run that is right, or a recording; or the session of an expert")
      ->required();
  command->add_option("ACTUAL", options->actual,
                      "the trace of another run, or a recording; or the session of a trainee");
  CLI::Option* const plant =
      command
          ->add_option(
              "--plant", options->plant,
              "run this plant.json or symbol list with the operations of EXPECTED, in place of ACTUAL, and show "
              "how accurate each movement is")
          ->type_name("PLANT");
  command
      ->add_option_function<std::string>(
          "--window", [options](const std::string& text) { read_window(text, *options); },
          "how far two changes may be apart (default: 0 in virtual time, else twice the coarser resolution)")
      ->type_name("T");
  command
      ->add_option_function<std::string>(
          "--tolerance", [options](const std::string& text) { read_tolerance(text, *options); },
          "how far numbers may be apart, as a share of the range of the expected ones (default: 1%)")
      ->type_name("P%");
  command
      ->add_option_function<std::string>(
          "--align", [options](const std::string& text) { read_align(text, *options); },
          "none: times as they are (default); follow: each relative to the change before it, for runs in which delays "
          "add up; "
          "SYMBOL: relative to the first change of SYMBOL to on")
      ->type_name("none|follow|SYMBOL");
  command->add_option("--only", options->how.only, "compare only these symbols and locations; may be repeated")
      ->type_name("PATTERN")
      ->allow_extra_args(false);
  command->add_option("--ignore", options->how.ignore, "do not compare these; may be repeated")
      ->type_name("PATTERN")
      ->allow_extra_args(false);
  add_recording_options(*command, options->recordings);
  std::vector<std::string> names;
  names.reserve(kCompareFormats.size());
  for (const CompareFormat& format : kCompareFormats) names.emplace_back(format.name);
  command
      ->add_option(
          "--format", options->format,
          "text: the first differences and counts; json: every difference; junit: a test case for each symbol; "
          "html: both as one chart")
      ->check(CLI::IsMember(names));
  command->add_option("-o,--output", options->output, "write the result to this file")->type_name("FILE");
  command->add_option("--html", options->html, "the same as `--format html --output FILE`")
      ->type_name("FILE")
      ->excludes("--format")
      ->excludes("--output");
  const std::vector<CLI::Option*> own = command->get_options();
  add_plant_options(*command, options->plant_options);
  for (CLI::Option* const option : command->get_options()) {
    if (std::find(own.begin(), own.end(), option) == own.end()) option->needs(plant);
  }
  command->footer(
      "Exit codes: 0 no difference; 1 differences; 2 bad input or usage. Of two sessions: 0 or 2.\n"
      "Examples:\n  symplant compare good.jsonl run.jsonl --only '*_O_*'\n"
      "  symplant compare good.jsonl beside-the-plc.jsonl --align follow --window 30ms --format html -o run.html\n"
      "  symplant compare recording.jsonl --plant plant.json --only '*_I_*'\n"
      "  symplant compare good.jsonl scope.csv --rename names.csv --time-unit ms\n"
      "  symplant compare expert.session.json anna.session.json --html anna.html");
  command->callback([options, &context] {
    if (!options->html.empty()) {
      options->format = "html";
      options->output = options->html;
    }
    const bool has_session = is_session_file(options->expected) || is_session_file(options->actual);
    has_session ? compare_sessions(*options, context) : compare_traces(*options, context);
  });
}

}  // namespace symplant::app

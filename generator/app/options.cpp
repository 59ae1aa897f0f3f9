// Options and messages that several commands share.
#include "app/options.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <array>
#include <filesystem>
#include <ostream>
#include <vector>

#include "app/stream_sink.hpp"
#include "check/catalogue.hpp"
#include "description/description_rules.hpp"
#include "description/plant_file.hpp"
#include "diag/text.hpp"
#include "diag/visible_text.hpp"
#include "read/io_words.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {
namespace {

text::Encoding encoding_of(const std::string& name) {
  if (const auto encoding = text::encoding_of_name(name)) return *encoding;
  throw CLI::ValidationError("--encoding", diag::visible(description::no_such_encoding(name)));
}

std::string format_names() {
  std::string names;
  for (const read::ReaderInfo* reader : read::readers()) names.append(names.empty() ? "" : ", ").append(reader->name);
  return names;
}

read::ColumnMap columns_of(const std::string& text) {
  auto map = read::column_map_of(text);
  if (map) return std::move(*map);
  throw CLI::ValidationError("--columns", diag::visible(map.error()));
}

/// Adds `events=P,..` or `operations=P,..`.
void add_io_rows(const std::string& text, name::IoRows& rows) {
  const std::size_t equals = text.find('=');
  const std::string side = text.substr(0, equals);
  if (equals == std::string::npos || equals + 1 == text.size() || (side != "events" && side != "operations")) {
    throw CLI::ValidationError(
        "--io", "`" + diag::visible(text) + "` names no rows: write events=PATTERN,.. or operations=PATTERN,..");
  }
  std::vector<std::string> patterns;
  for (std::size_t begin = equals + 1; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if (end > begin) patterns.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  rows.add(patterns, side == "events" ? name::Direction::event : name::Direction::operation, {});
}

address::IoRanges words_of(const std::string& text) {
  auto words = read::io_words_of(text);
  if (words) return std::move(*words);
  throw CLI::ValidationError("--cio", diag::visible(words.error()));
}

}  // namespace

void add_plant_options(CLI::App& command, PlantOptions& options) {
  command
      .add_option("--input-format", options.read.input_format,
                  "the format of the list (default: detected): " + format_names())
      ->type_name("FORMAT");
  command
      .add_option_function<std::string>(
          "--columns", [&options](const std::string& text) { options.read.columns = columns_of(text); },
          "the columns of a table, by header or number (default: detected): name=Tag,address=3; also type, initial, "
          "comment, class, scope, iec-address, and sheet=NAME of a workbook")
      ->type_name("FIELD=COLUMN,..");
  command
      .add_option_function<std::string>(
          "--cio", [&options](const std::string& text) { options.read.io_words = words_of(text); },
          "which words of the CIO area of an Omron PLC are inputs or outputs: inputs=0-99,outputs=100-199")
      ->type_name("SIDE=FIRST-LAST,..");
  command
      .add_option_function<std::string>(
          "--encoding", [&options](const std::string& name) { options.read.encoding = encoding_of(name); },
          "the encoding of the list (default: detected): utf-8, utf-16le, utf-16be, cp932 (shift_jis), cp949 "
          "(euc-kr), "
          "gb18030 (gbk), cp950 (big5), cp1250 to cp1258 (cp1252 is latin1), cp874, cp437, cp850, cp852, cp866")
      ->type_name("ENCODING");
  command
      .add_option_function<std::string>(
          "--xy",
          [&options](const std::string& text) {
            if (text != "hex" && text != "octal") {
              throw CLI::ValidationError("--xy", "`" + text + "` is not a base for X and Y: write hex or octal");
            }
            options.xy = text == "hex" ? address::Radix::hexadecimal : address::Radix::octal;
          },
          "how X and Y count if no row proves it (default: hex)")
      ->type_name("hex|octal");
  command
      .add_option("--naming", options.naming,
                  "how names are read: a naming.json, or a ready profile (`symplant naming` lists them) (default: the "
                  "naming of plant.json, else LINE_PROC_DEV_I|O_TASK)")
      ->type_name("FILE|@PROFILE");
  command
      .add_option_function<std::vector<std::string>>(
          "--io",
          [&options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) add_io_rows(text, options.io);
          },
          "rows that are I/O although their address is internal (%M, M, D) or missing, by name or address; `*` is any "
          "text; may be given once for each direction (default: the io of plant.json)")
      ->allow_extra_args(false)
      ->type_name("events=P,..|operations=P,..");
  command.add_flag("--verbose", options.verbose, "show what was decided and why, and notes");
}

namespace {

/// How X and Y of a list count, and what decided it.
std::string radix_text(const model::PlantModel& plant, std::uint32_t index) {
  const model::PlantList& list = plant.lists[index];
  const std::string_view counts = list.radix.radix == address::Radix::hexadecimal ? "hexadecimal" : "octal";
  const std::string of = plant.lists.size() == 1 ? "" : " of " + list.name();
  switch (list.radix.by) {
    case model::RadixChoice::By::rows: {
      const std::uint32_t other = plant.list_of(*list.radix.proof);
      return fmt::format("X and Y{} count in {}, as {}line {} proves", of, counts,
                         other == index ? "" : plant.lists[other].name() + " ", list.radix.proof->line);
    }
    case model::RadixChoice::By::option:
      return fmt::format("X and Y{} count in {}, as --xy says", of, counts);
    case model::RadixChoice::By::nothing:
      break;
  }
  return fmt::format("X and Y{} count in {} by default", of, counts);
}

/// How many symbols of a list have their direction from their address, alias or name.
std::string direction_text(const model::PlantModel& plant, std::uint32_t index) {
  constexpr std::array<std::string_view, 3> kEvidence{"name", "address", "alias"};  // in the order of DirectionBy
  std::array<std::size_t, 3> counts{};
  for (const model::Symbol& symbol : plant.symbols) {
    if (symbol.list == index) ++counts[static_cast<std::size_t>(symbol.direction_by)];
  }
  std::string text;
  for (const std::size_t by : {1U, 2U, 0U}) {
    if (counts[by] != 0) text += fmt::format("{}{} by {}", text.empty() ? "" : ", ", counts[by], kEvidence[by]);
  }
  const std::string of = plant.lists.size() == 1 ? "" : " of " + plant.lists[index].name();
  return fmt::format("directions{}: {}", of, text.empty() ? "none" : text);
}

}  // namespace

void report_decisions(Context& context, const Compiled& compiled) {
  const model::PlantModel& plant = compiled.plant;
  if (plant.description_source != nullptr) {
    context.err << "decided: the plant is called " << diag::visible(plant.name) << "\n";
    for (const std::string& decision : compiled.evidence.decisions) {
      context.err << "decided: " << diag::visible(decision) << "\n";
    }
  }
  for (std::uint32_t i = 0; i < plant.lists.size(); ++i) {
    for (const std::string& decision : plant.lists[i].table->decisions) {
      const std::string of = plant.lists.size() == 1 ? "" : plant.lists[i].name() + ": ";
      context.err << "decided: " << of << decision << "\n";
    }
    if (plant.lists[i].table->notation == address::Notation::melsec) {
      context.err << "decided: " << radix_text(plant, i) << "\n";
    }
    context.err << "decided: " << direction_text(plant, i) << "\n";
  }
}

std::string count_text(const diag::Diagnostics& diagnostics, diag::Severity least) {
  std::string text;
  for (const diag::Severity severity : {diag::Severity::error, diag::Severity::warning, diag::Severity::note}) {
    if (severity < least) continue;
    const std::size_t count = diagnostics.count(severity);
    if (count == 0) continue;
    text +=
        fmt::format("{}{} {}{}", text.empty() ? "" : ", ", count, diag::severity_name(severity), count == 1 ? "" : "s");
  }
  if (text.empty()) text = "no findings";
  if (!diagnostics.ignored().empty()) text += fmt::format(", {} ignored by plant.json", diagnostics.ignored().size());
  std::size_t consequences = 0;
  for (const diag::Ignored& ignored : diagnostics.ignored()) consequences += ignored.finding.shown_consequences;
  if (consequences != 0) text += fmt::format(" and {} that follow from them", consequences);
  return text;
}

void report_ignored(Context& context, const diag::Diagnostics& diagnostics) {
  for (const diag::Ignored& ignored : diagnostics.ignored()) {
    const diag::RuleInfo& rule = *ignored.finding.rule;
    context.err << fmt::format("ignored: {} [{} {}], reason: {}\n", diag::visible(ignored.finding.message), rule.id,
                               rule.slug, diag::visible(ignored.why));
  }
}

namespace {

bool is_in(const diag::Diagnostic& finding, const std::string& file) {
  if (file.empty() || finding.location.source == nullptr) return false;
  const auto absolute = [](const std::string& path) { return std::filesystem::absolute(path).lexically_normal(); };
  return absolute(finding.location.source->path()) == absolute(file);
}

/// Shows the errors, and those of the file of times, which `symplant check` does not read; with --verbose all findings.
void show_findings(Context& context, const diag::Diagnostics& diagnostics, bool verbose, const std::string& times) {
  std::vector<diag::Diagnostic> shown;
  for (const diag::Diagnostic& finding : diagnostics.all()) {
    if (verbose || check::is_stopping(finding) || is_in(finding, times)) shown.push_back(finding);
  }
  context.err << diag::render_text(shown, {.colour = context.colour_err, .all = verbose, .most_errors = 5});
  if (verbose) report_ignored(context, diagnostics);
}

/// Shows how many findings there are. Removes the result and sets the exit code if one of them stops.
template <class Result>
void show_counts(Context& context, const std::string& plant, const diag::Diagnostics& diagnostics, bool verbose,
                 std::optional<Result>& result) {
  const std::string counts = count_text(diagnostics, verbose ? diag::Severity::note : diag::Severity::warning);
  if (!result || check::has_stopping_errors(diagnostics)) {
    result.reset();
    context.err << diag::visible(plant) << ": " << counts << "; fix the errors first\n";
    context.exit_code = host::kBadInput;
  } else if (diagnostics.count(diag::Severity::warning) + diagnostics.count(diag::Severity::error) != 0 && !verbose) {
    context.err << diag::visible(plant) << ": " << counts << "; `symplant check` shows them\n";
  }
}

}  // namespace

CompileOptions compile_options(const Context& context, const std::string& plant, const PlantOptions& options) {
  CompileOptions compiled{plant, options.read, options.xy, context.today};
  compiled.naming = options.naming;
  compiled.malfunctions = options.malfunctions;
  compiled.conventions = options.conventions;
  compiled.times = options.times;
  compiled.io = options.io;
  return compiled;
}

std::optional<Compiled> compile_for(Context& context, const std::string& plant, const PlantOptions& options) {
  diag::Diagnostics diagnostics;
  Progress progress(context.err, context.progress);
  auto compiled = compile(compile_options(context, plant, options), context.files, progress, diagnostics);
  show_findings(context, diagnostics, options.verbose, options.times);
  if (compiled && options.verbose) report_decisions(context, *compiled);
  show_counts(context, plant, diagnostics, options.verbose, compiled);
  return compiled;
}

std::optional<Compiled> compile_for_report(Context& context, const std::string& plant, const PlantOptions& options,
                                           bool& sound) {
  diag::Diagnostics diagnostics;
  Progress progress(context.err, context.progress);
  auto compiled = compile(compile_options(context, plant, options), context.files, progress, diagnostics);
  sound = compiled && !check::has_stopping_errors(diagnostics);
  if (!compiled) {
    show_findings(context, diagnostics, options.verbose, options.times);
    show_counts(context, plant, diagnostics, options.verbose, compiled);
    return compiled;
  }
  if (options.verbose) report_decisions(context, *compiled);
  if (!sound) {
    const std::string counts = count_text(diagnostics, diag::Severity::error);
    context.err << diag::visible(plant) << ": " << counts << "; `symplant check` shows them\n";
  }
  return compiled;
}

std::optional<Inputs> read_for(Context& context, const std::string& plant, const PlantOptions& options) {
  diag::Diagnostics diagnostics;
  Progress progress(context.err, context.progress);
  auto inputs = read_inputs(compile_options(context, plant, options), context.files, progress, diagnostics);
  if (inputs && inputs->source != nullptr) description::add_findings(*inputs->source, inputs->faults, diagnostics);
  show_findings(context, diagnostics, options.verbose, options.times);
  show_counts(context, plant, diagnostics, options.verbose, inputs);
  return inputs;
}

bool overwrites(Context& context, const std::string& output, const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    std::error_code unknown;  // a missing file is never the same file
    if (!std::filesystem::equivalent(output, input, unknown) || unknown) continue;
    context.err << "error: `" << output << "` is an input: writing there would destroy it; name another file\n";
    context.exit_code = host::kBadInput;
    return true;
  }
  return false;
}

bool write_result(Context& context, const std::string& file, const base::TextSource& text,
                  const std::vector<std::string>& inputs) {
  if (file.empty()) {
    StreamSink out(context.out);
    text(out);
    return true;
  }
  if (overwrites(context, file, inputs)) return false;
  const auto written = context.files.write_made(file, text);
  if (written) return true;
  context.err << "error: " << written.error().message << "\n";
  context.exit_code = host::kEnvironment;
  return false;
}

}  // namespace symplant::app

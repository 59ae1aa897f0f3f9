// symplant convert: writes the symbols of lists in the format of another tool.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <memory>
#include <ostream>
#include <utility>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "app/renames_file.hpp"
#include "convert/cells.hpp"
#include "convert/writers.hpp"
#include "diag/visible_text.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {
namespace {

struct ConvertOptions {
  std::string input;
  std::string output;
  std::string format;
  std::string dialect;
  std::string renames;  ///< to apply
  std::string renamed;  ///< to write
  PlantOptions plant_options;

  bool to_stream() const { return output == "-"; }
};

std::string extensions() {
  std::string text;
  for (const convert::WriterInfo* writer : convert::writers()) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", writer->extension, writer->name);
  }
  return text;
}

/// Why the options do not fit together; empty if they do.
std::string fault_of(const ConvertOptions& options, const convert::WriterInfo* writer) {
  if (writer == nullptr) {
    return "the name `" + options.output + "` shows no format (" + extensions() + "); give one with --to";
  }
  if (options.to_stream() && !writer->is_text) {
    return fmt::format("`{}` is not text: name a file instead of `-`", writer->name);
  }
  if (!options.dialect.empty() && !writer->has_dialects) {
    return fmt::format("`{}` has no dialects: leave out --dialect, or convert to st or plcopen", writer->name);
  }
  const auto same = [](const std::string& a, const std::string& b) {
    return std::filesystem::path(a).lexically_normal() == std::filesystem::path(b).lexically_normal();
  };
  if (!options.renamed.empty() && same(options.renamed, options.output)) {
    return "`" + options.renamed + "` is the output, too: name another file for --renamed";
  }
  if (options.renamed == "-") return "--renamed writes to a file: name one instead of `-`";
  return {};
}

const convert::WriterInfo* writer_for(const ConvertOptions& options) {
  return options.format.empty()
             ? convert::writer_of_extension(std::filesystem::path(options.output).extension().generic_string())
             : convert::find_writer(options.format);
}

std::shared_ptr<const convert::Symbols> symbols_in(const Inputs& inputs) {
  std::vector<convert::List> lists;
  for (const ReadList& list : inputs.lists) lists.push_back({list.table, list.controller, list.xy});
  return std::make_shared<const convert::Symbols>(convert::symbols_of(lists));
}

std::vector<std::string> files_of(const Inputs& inputs) {
  std::vector<std::string> files;
  if (inputs.source != nullptr) files = inputs.source->paths();
  if (inputs.naming_parts != nullptr) {
    files.insert(files.end(), inputs.naming_parts->files.begin(), inputs.naming_parts->files.end());
  }
  for (const ReadList& list : inputs.lists) files.push_back(list.table->source->path());
  return files;
}

base::TextSource renames_csv(std::vector<convert::Rename> renames) {
  return [renames = std::move(renames)](base::TextSink& sink) {
    base::PartCollector parts(sink);
    parts.add("old,new\n");
    std::string row;
    for (const auto& [from, to] : renames) {
      row.clear();
      convert::append_protected_cell(row, from);
      convert::append_protected_cell(row += ',', to);
      parts.add(row += '\n');
    }
    parts.finish();
  };
}

/// "out.st: 18 symbols written, 16 of them I/O (8 inputs, 8 outputs)"
std::string summary(const ConvertOptions& options, const convert::WriterInfo& writer, const convert::Written& written) {
  const std::string where = options.to_stream() ? std::string(writer.name) : options.output;
  return fmt::format("{}: {} symbol{} written, {} of them I/O ({} input{}, {} output{})", where, written.symbols,
                     written.symbols == 1 ? "" : "s", written.inputs + written.outputs, written.inputs,
                     written.inputs == 1 ? "" : "s", written.outputs, written.outputs == 1 ? "" : "s");
}

void report_lists(Context& context, const Inputs& inputs) {
  for (const ReadList& list : inputs.lists) {
    for (const std::string& decision : list.table->decisions) {
      const std::string of = inputs.lists.size() == 1 ? "" : list.table->source->path() + ": ";
      context.err << "decided: " << diag::visible(of + decision) << "\n";
    }
  }
}

void convert_lists(const ConvertOptions& options, Context& context) {
  const auto fail = [&](const std::string& message) {
    context.err << "error: " << diag::visible(message) << "\n";
    context.exit_code = host::kBadInput;
  };
  const convert::WriterInfo* const writer = writer_for(options);
  if (const std::string fault = fault_of(options, writer); !fault.empty()) return fail(fault);
  const auto inputs = read_for(context, options.input, options.plant_options);
  if (!inputs) return;
  if (options.plant_options.verbose) report_lists(context, *inputs);
  auto symbols = symbols_in(*inputs);
  if (!options.renames.empty()) {
    const auto others = rename_symbols(*symbols, options.renames, context.files);
    if (!others) {
      for (const std::string& fault : others.error()) context.err << diag::visible(fault) << "\n";
      context.exit_code = host::kBadInput;
      return;
    }
    symbols = *others;
  }
  context.kept = symbols;
  const convert::Dialect& dialect =
      options.dialect.empty() ? convert::dialects().front() : *convert::find_dialect(options.dialect);
  convert::Report report;
  const auto made = convert::write(*writer, {symbols, dialect, options.plant_options.xy, report});
  if (!made) return fail(made.error().message);
  std::vector<std::string> files = files_of(*inputs);
  if (!options.renames.empty()) files.push_back(options.renames);
  if (!options.renamed.empty() && overwrites(context, options.renamed, files)) return;
  if (!write_result(context, options.to_stream() ? "" : options.output, made->text, files)) return;
  if (!options.renamed.empty() && !write_result(context, options.renamed, renames_csv(report.renames()), files)) return;
  for (const std::string& line : report.lines()) context.err << line << "\n";
  context.err << diag::visible(summary(options, *writer, made->written)) << "\n";
}

std::vector<std::string> dialect_names() {
  std::vector<std::string> names;
  for (const convert::Dialect& dialect : convert::dialects()) names.emplace_back(dialect.name);
  return names;
}

}  // namespace

void add_convert(CLI::App& app, Context& context) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = app.add_subcommand("convert", "Write the symbols of a list in the format of another tool");
  command->add_option("IN", options->input, "a symbol list, or a plant.json: all its lists")->required();
  command->add_option("OUT", options->output, "the file to write; - for standard output")->required();
  std::vector<std::string> names;
  std::string help;
  for (const convert::WriterInfo* writer : convert::writers()) {
    names.emplace_back(writer->name);
    help += fmt::format("{}{}: {}", help.empty() ? "" : "; ", writer->name, writer->title);
  }
  command
      ->add_option("--to", options->format,
                   "the format (default: by the extension of OUT: " + extensions() + "). " + help)
      ->check(CLI::IsMember(names))
      ->type_name("FORMAT");
  command->add_option("--dialect", options->dialect, "the tool for which st and plcopen are written (default: codesys)")
      ->check(CLI::IsMember(dialect_names()))
      ->type_name("codesys|twincat|openplc");
  command
      ->add_option("--renames", options->renames,
                   "rename symbols as this CSV file says, with the columns old and new; `symplant check "
                   "--rename-map` proposes some")
      ->type_name("FILE");
  command->add_option("--renamed", options->renamed, "write the names that were changed to this file: old,new")
      ->type_name("FILE");
  add_plant_options(*command, options->plant_options);
  command->footer(
      "What the format cannot hold is reported, one line for each kind.\n"
      "Examples:\n  symplant convert symbols.csv symbols.xlsx\n"
      "  symplant convert plant.json io.st --dialect openplc --renamed renamed.csv\n"
      "  symplant convert symbols.csv - --to gx-iec");
  command->callback([options, &context] { convert_lists(*options, context); });
}

}  // namespace symplant::app

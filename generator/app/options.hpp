// Options and messages that several commands share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pipeline.hpp"
#include "app/read_inputs.hpp"
#include "app/tool.hpp"

namespace symplant::app {

/// The options of every command that reads a plant: --input-format, --encoding, --xy, --naming, --verbose.
struct PlantOptions {
  read::ReadOptions read;
  std::optional<address::Radix> xy;
  std::string naming;
  std::string malfunctions;  ///< a file with more malfunctions; empty: none
  std::string conventions;   ///< a file with more naming conventions; empty: none
  std::string times;         ///< a description that wins over the plant, such as learned times; empty: none
  name::IoRows io;
  bool verbose = false;
};
void add_plant_options(CLI::App& command, PlantOptions& options);

/// The options of compile() for a command.
CompileOptions compile_options(const Context& context, const std::string& plant, const PlantOptions& options);

/// compile() for a command. Shows the errors on `context.err`, and the warnings as a line of counts (with --verbose all
/// findings). If there are errors, returns no value and sets the exit code to 2.
std::optional<Compiled> compile_for(Context& context, const std::string& plant, const PlantOptions& options);

/// Like compile_for(), for a command that only reports about the plant: also returns a plant with errors. Sets `sound`
/// to whether the plant has no errors.
std::optional<Compiled> compile_for_report(Context& context, const std::string& plant, const PlantOptions& options,
                                           bool& sound);

/// The lists of a plant, for a command that does not need its model. Messages and exit code are those of compile_for().
std::optional<Inputs> read_for(Context& context, const std::string& plant, const PlantOptions& options);

/// Shows the decisions of the reader, for --verbose.
void report_decisions(Context& context, const Compiled& compiled);

/// Shows the findings that plant.json ignores, with the reasons, for --verbose.
void report_ignored(Context& context, const diag::Diagnostics& diagnostics);

/// Whether an output would overwrite an input. If so, reports it and sets the exit code.
bool overwrites(Context& context, const std::string& output, const std::vector<std::string>& inputs);

/// Writes a result to `file`, or to `context.out` if `file` is empty. Returns false and sets the exit code if writing
/// fails or the file is one of `inputs`.
bool write_result(Context& context, const std::string& file, const base::TextSource& text,
                  const std::vector<std::string>& inputs);

/// "3 warnings, 1 note, 2 ignored by plant.json"; counts findings of severity `least` or higher.
std::string count_text(const diag::Diagnostics& diagnostics, diag::Severity least = diag::Severity::note);

}  // namespace symplant::app

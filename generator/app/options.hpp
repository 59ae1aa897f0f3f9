// Options and messages that several commands share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pipeline.hpp"
#include "app/tool.hpp"

namespace symplant::app {

/// What every command that reads a plant takes: --input-format, --encoding, --xy, --verbose.
struct PlantOptions {
  read::ReadOptions read;
  std::optional<address::Radix> xy;
  bool verbose = false;
};
void add_plant_options(CLI::App& command, PlantOptions& options);

/// compile() for a command: shows errors and warnings on `context.err` (notes with --verbose) and sets the exit code to
/// 2 where there is nothing to go on with.
std::optional<Compiled> compile_for(Context& context, const std::string& plant, const PlantOptions& options);

/// Tells what the reader decided, for --verbose.
void report_decisions(Context& context, const model::PlantModel& plant);

/// Tells the findings that plant.json ignores, and why, for --verbose.
void report_ignored(Context& context, const diag::Diagnostics& diagnostics);

/// Whether an output would take the place of an input; says so and sets the exit code.
bool overwrites(Context& context, const std::string& output, const std::vector<std::string>& inputs);

/// Writes a result: to the file where one is named, else to `context.out`. False, and the exit code set, where it
/// fails or the file is one of `inputs`.
bool write_result(Context& context, const std::string& file, const std::string& text,
                  const std::vector<std::string>& inputs);

/// "3 warnings, 1 note, 2 ignored by plant.json"; of those alone that weigh `least` or more.
std::string count_text(const diag::Diagnostics& diagnostics, diag::Severity least = diag::Severity::note);

}  // namespace symplant::app

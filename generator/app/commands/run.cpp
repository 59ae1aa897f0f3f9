// symplant run: runs a plant without a compiler.
#include "symplant/host/run.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "app/prepared_plant.hpp"
#include "app/with_faults.hpp"
#include "base/large_memory.hpp"
#include "symplant/host/result_files.hpp"
#include "symplant/host/run_options.hpp"

namespace symplant::app {
namespace {

struct RunOptions {
  std::string plant;
  PlantOptions plant_options;
  host::RunOptions run;
};

/// What a plant may be read from, as far as it shows before it is read: itself, the naming rule, and each result file
/// whose name is in the text of a plant.json, which may have faults.
std::vector<std::string> possible_inputs(const Context& context, const std::string& plant, const std::string& naming,
                                         const host::RunOptions& run) {
  std::vector<std::string> files;
  if (!plant.empty()) files.push_back(plant);
  if (!naming.empty()) files.push_back(naming);
  if (std::filesystem::path(plant).extension() != ".json") return files;
  const auto text = context.files.read(plant);
  for (const std::string& file : {run.junit, run.findings, run.stats}) {
    const std::string name = std::filesystem::path(file).filename().generic_string();
    if (text && !name.empty() && text->find(name) != std::string::npos) files.push_back(file);
  }
  return files;
}

}  // namespace

void add_run(CLI::App& app, Context& context) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Run the plant, with a PLC or in virtual time; no compiler is needed");
  command->add_option("PLANT", options->plant, "a plant.json or a symbol list")->required();
  host::add_run_options(*command, options->run);
  command
      ->add_option("--faults", options->plant_options.malfunctions,
                   "a file with a list of malfunctions that the plant has, too, as for `symplant campaign`")
      ->type_name("FILE");
  add_plant_options(*command, options->plant_options);
  command->footer(
      "Examples:\n  symplant run symbols.csv --link modbus-tcp-server://127.0.0.1:1502\n"
      "  symplant run plant.json --cycle 1ms --priority 50 --cpu 1 --lock-memory --stay-awake --stats stats.json\n"
      "  symplant run plant.json --until 10s --trace trace.jsonl\n"
      "  symplant run plant.json --link PLC1=modbus-tcp-server://:1502 --link PLC2=modbus-tcp-server://:1503\n"
      "  symplant run symbols.csv --program cell.so --scenario first_cycle.json\n"
      "  symplant run symbols.csv --scenario first_cycle.json --vcd run.vcd --junit report.xml\n"
      "  symplant run symbols.csv --scenario first_cycle.json --why LINE_P1_CLAMP1 --why LINE_P1_CLAMP1_I_CLOSED");
  command->callback([options, &context] {
    std::optional<Compiled> compiled;
    const std::vector<std::string> possible =
        possible_inputs(context, options->plant, options->plant_options.naming, options->run);
    const std::vector<std::string_view> inputs(possible.begin(), possible.end());
    context.exit_code =
        host::with_results(options->run, options->plant, context.out, context.err, [&](host::ResultFiles& files) {
          files.replace_unless_among(inputs);
          compiled = compile_for(context, options->plant, options->plant_options);
          return context.exit_code;
        });
    if (!compiled) return;
    if (!options->run.fault.empty() || is_of_fault_run(options->run.replay, *compiled))
      add_fault_malfunctions(*compiled);
    const PreparedPlant prepared(std::move(*compiled), options->plant);
    compiled.reset();
    base::return_freed_memory();
    context.exit_code = host::run(prepared.program(), options->run, context.out, context.err);
  });
}

void fail_run(const CLI::App& app, std::string_view error, const Context& context) {
  const CLI::App* const command = app.get_subcommand("run");
  if (!command->parsed()) return;
  const auto first = [&](const char* name) {
    const auto& results = command->get_option(name)->results();
    return results.empty() ? std::string() : results.front();
  };
  const host::RunOptions files = host::result_files_of(*command);
  const std::vector<std::string> possible = possible_inputs(context, first("PLANT"), first("--naming"), files);
  const std::vector<std::string_view> inputs(possible.begin(), possible.end());
  host::fail_unread_run(files, inputs, "symplant run", error, context.out);
}

}  // namespace symplant::app

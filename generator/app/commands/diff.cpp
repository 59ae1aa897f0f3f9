// symplant diff: what changed between two plants.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "diff/compare.hpp"
#include "diff/formats.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {
namespace {

struct DiffOptions {
  std::string before;
  std::string after;
  std::string format = "text";
  std::string output;
  PlantOptions plant_options;
};

/// Both plants and their difference, kept until the program ends.
struct Compared {
  Compiled before;
  Compiled after;
  diff::Difference difference;
};

base::TextSource text_of(const DiffOptions& options, const Compared& compared) {
  return [&](base::TextSink& sink) {
    const diff::Comparison comparison{compared.before.plant, compared.after.plant, compared.difference, options.before,
                                      options.after};
    if (options.format == "json") return diff::write_json(comparison, sink);
    if (options.format == "markdown") return diff::write_markdown(comparison, sink);
    diff::write_text(comparison, options.plant_options.verbose, sink);
  };
}

void compare_plants(const DiffOptions& options, Context& context) {
  bool sound_before = false;
  bool sound_after = false;
  auto before = compile_for_report(context, options.before, options.plant_options, sound_before);
  auto after = compile_for_report(context, options.after, options.plant_options, sound_after);
  if (!before || !after) return;
  const auto compared = std::make_shared<Compared>(Compared{std::move(*before), std::move(*after), {}});
  context.kept = compared;
  compared->difference = diff::compare({compared->before.plant, sound_before ? &compared->before.tables : nullptr},
                                       {compared->after.plant, sound_after ? &compared->after.tables : nullptr});
  std::vector<std::string> inputs = compared->before.plant.input_files();
  for (std::string& file : compared->after.plant.input_files()) inputs.push_back(std::move(file));
  if (!write_result(context, options.output, text_of(options, *compared), inputs)) return;
  if (!compared->difference.empty()) context.exit_code = host::kFindings;
}

}  // namespace

void add_diff(CLI::App& app, Context& context) {
  auto options = std::make_shared<DiffOptions>();
  CLI::App* command = app.add_subcommand("diff", "Compare two plants: symbols, devices and their models");
  command->add_option("OLD", options->before, "a symbol list or a plant.json")->required();
  command->add_option("NEW", options->after, "the list or the plant.json that replaces it")->required();
  command
      ->add_option("--format", options->format,
                   "text: for a terminal (--verbose: every change); json: every change; markdown: for a pull request")
      ->check(CLI::IsMember({"text", "json", "markdown"}));
  command->add_option("-o,--output", options->output, "write the result to this file")->type_name("FILE");
  add_plant_options(*command, options->plant_options);
  command->footer(
      "Exit codes: 0 equal; 1 different; 2 bad input or usage.\n"
      "Examples:\n  symplant diff old.csv new.csv\n  symplant diff old/plant.json plant.json --format markdown");
  command->callback([options, &context] { compare_plants(*options, context); });
}

}  // namespace symplant::app

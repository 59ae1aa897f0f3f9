// symplant check: naming and model diagnostics.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <memory>
#include <numeric>
#include <ostream>
#include <utility>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "check/selection.hpp"
#include "diag/json.hpp"
#include "diag/text.hpp"
#include "diag/visible_text.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {
namespace {

struct CheckOptions {
  std::vector<std::string> plants;
  PlantOptions plant;
  std::string format = "text";
  std::string output;
  std::string fail_on = "error";
  std::vector<std::string> select;
  std::vector<std::string> ignore;
};

check::Selection selection_of(const CheckOptions& options) {
  const auto selection = check::Selection::of(options.select, options.ignore);
  if (!selection) throw CLI::ValidationError("--select/--ignore", diag::visible(selection.error()));
  return *selection;
}

bool reaches(const diag::Diagnostics& diagnostics, const std::string& fail_on) {
  std::size_t count = diagnostics.count(diag::Severity::error);
  if (fail_on != "error") count += diagnostics.count(diag::Severity::warning);
  if (fail_on == "note") count += diagnostics.count(diag::Severity::note);
  return count != 0;
}

/// "no findings, 3 left out by --ignore".
std::string selected_text(const check::Selected& selected) {
  std::string text = count_text(selected.findings);
  if (selected.not_selected != 0) text += fmt::format(", {} left out by --select", selected.not_selected);
  if (selected.ignored != 0) text += fmt::format(", {} left out by --ignore", selected.ignored);
  return text;
}

/// How many names follow the rule, and what that makes of the plant.
std::string result_line(const std::string& list, const model::PlantModel& plant, const check::Selected& selected) {
  const auto named = std::count_if(plant.symbols.begin(), plant.symbols.end(), [](const model::Symbol& symbol) {
    return symbol.reading.fault == name::NameFault::none;
  });
  const std::size_t internal = std::accumulate(plant.internal.begin(), plant.internal.end(), std::size_t{0});
  const std::string lists = plant.lists.size() == 1 ? "" : fmt::format(" of {} lists", plant.lists.size());
  return fmt::format("{}: {} of {} I/O names{} follow {}, {} device{}{}; {}\n", list, named, plant.symbols.size(),
                     lists, plant.rule->pattern, plant.units.size(), plant.units.size() == 1 ? "" : "s",
                     internal == 0 ? "" : fmt::format(", {} internal row{}", internal, internal == 1 ? "" : "s"),
                     selected_text(selected));
}

void check(const CheckOptions& options, Context& context) {
  const check::Selection selection = selection_of(options);
  std::string text;
  std::vector<diag::Diagnostic> all;
  std::vector<std::string> inputs = options.plants;
  diag::LeftOut left_out;
  for (const std::string& list : options.plants) {
    diag::Diagnostics diagnostics;
    int code = host::kGood;
    {
      Progress progress(context.err, context.progress);
      const auto plant =
          analyse({list, options.plant.read, options.plant.xy, context.today}, context.files, progress, diagnostics);
      if (plant) {
        const std::vector<std::string> read = plant->input_files();
        inputs.insert(inputs.end(), read.begin(), read.end());
      }
      if (plant && options.plant.verbose) tell_decisions(context, *plant);
      const check::Selected selected = check::select(std::move(diagnostics), selection);
      if (options.plant.verbose) tell_ignored(context, selected.findings);
      left_out.by_description += selected.findings.ignored().size();
      left_out.by_options += selected.not_selected + selected.ignored;
      if (!plant) {
        code = host::kBadInput;
      } else if (reaches(selected.findings, options.fail_on)) {
        code = host::kFindings;
      }
      const auto findings = selected.findings.all();
      if (options.format == "text") {
        text += diag::render_text(findings, {context.colour_out && options.output.empty(),
                                             options.plant.verbose ? std::size_t{0} : std::size_t{20}});
        if (plant) text += result_line(list, *plant, selected);
      }
      all.insert(all.end(), findings.begin(), findings.end());
    }
    context.exit_code = std::max(context.exit_code, code);
  }
  if (options.format == "json") text = diag::render_json(all, left_out) + "\n";
  write_result(context, options.output, text, inputs);
}

}  // namespace

void add_check(CLI::App& app, Context& context) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "Check names and models; say what the model loses by each fault");
  command->add_option("PLANT", options->plants, "plant.json files or symbol lists, each a plant of its own")
      ->required();
  command->add_option("--format", options->format, "text for people, json for programs")
      ->check(CLI::IsMember({"text", "json"}));
  command->add_option("--output", options->output, "write the result to this file")->type_name("FILE");
  command->add_option("--fail-on", options->fail_on, "the severity from which on the exit code is 1 (default: error)")
      ->check(CLI::IsMember({"error", "warning", "note"}));
  command
      ->add_option("--select", options->select,
                   "tell these rules only: ids, slugs, beginnings of ids (SP4); errors that leave no sound plant are "
                   "always told")
      ->type_name("RULE,..")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--ignore", options->ignore, "leave these rules out; of --select and --ignore the more exact counts")
      ->type_name("RULE,..")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_plant_options(*command, options->plant);
  command->footer(
      "Examples:\n  symplant check symbols.csv\n  symplant check --fail-on warning --format json line1.csv line2.csv\n"
      "  symplant check --select SP2,SP3 --ignore no-address symbols.csv");
  command->callback([options, &context] { check(*options, context); });
}

}  // namespace symplant::app

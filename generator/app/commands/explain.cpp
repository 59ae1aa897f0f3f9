// symplant explain: the manual page of a rule, or how the naming rule reads a symbol.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>
#include <ostream>

#include "app/commands.hpp"
#include "app/explain_symbol.hpp"
#include "app/options.hpp"
#include "check/catalogue.hpp"
#include "diag/visible_text.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {
namespace {

struct ExplainOptions {
  std::string subject;  ///< a rule, or with `symbol` a plant
  std::string symbol;
  PlantOptions plant;
};

void explain_rule(const std::string& rule, Context& context) {
  const diag::RuleInfo* info = check::find_rule(rule);
  const std::string former = check::former_rule(rule);
  if (info == nullptr) {
    context.err << "error: " << diag::visible(former.empty() ? check::no_such_rule(rule) : former) << "\n";
    context.exit_code = host::kBadInput;
    return;
  }
  if (!former.empty()) context.err << "warning: " << former << "\n";
  context.out << "# " << info->id << " " << info->slug << "\n\n"
              << "Severity: " << diag::severity_name(info->severity) << "; " << info->summary << ".\n\n"
              << diag::manual_page(*info);
}

void explain_symbol(const ExplainOptions& options, Context& context) {
  bool sound = false;
  const auto compiled = compile_for_report(context, options.subject, options.plant, sound);
  if (!compiled) return;
  if (const auto text = symbol_text(compiled->plant, options.symbol)) {
    context.out << *text;
    return;
  }
  const std::string nearest = nearest_symbol(compiled->plant, options.symbol);
  context.err << "error: no input or output is named `" << diag::visible(options.symbol) << "`"
              << (nearest.empty() ? "" : "; did you mean `" + diag::visible(nearest) + "`?") << "\n";
  context.exit_code = host::kBadInput;
}

}  // namespace

void add_explain(CLI::App& app, Context& context) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command =
      app.add_subcommand("explain", "Show the manual page of a rule, or how the naming rule reads a symbol");
  command->add_option("RULE", options->subject, "a rule's id or slug; with --symbol a plant.json or a symbol list")
      ->required();
  command->add_option("--symbol", options->symbol,
                      "a name in the list: each rule and where it ends, the device, and the nearest names");
  add_plant_options(*command, options->plant);
  command->footer(
      "Examples:\n  symplant explain SP201\n  symplant explain wrong-number-of-levels\n"
      "  symplant explain --symbol iConv17_prox symbols.csv --naming naming.json");
  command->callback([options, &context] {
    if (options->symbol.empty()) return explain_rule(options->subject, context);
    explain_symbol(*options, context);
  });
}

}  // namespace symplant::app

// symplant rules: the catalogue.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/commands.hpp"
#include "check/catalogue.hpp"

namespace symplant::app {
namespace {

std::string as_markdown() {
  std::string text =
      "# Rules\n\nWhat `symplant check` looks for; made by `symplant rules`. `symplant explain RULE` shows a page "
      "alone.\n\n"
      "| rule | name | severity | what it says |\n|---|---|---|---|\n";
  for (const diag::RuleInfo* rule : check::catalogue()) {
    // Markdown's own anchors are in lower case.
    text += fmt::format("| {} | [{}](#sp{}-{}) | {} | {} |\n", rule->id, rule->slug, rule->id.substr(2), rule->slug,
                        diag::severity_name(rule->severity), rule->summary);
  }
  for (const diag::RuleInfo* rule : check::catalogue()) {
    text += fmt::format("\n## {} {}\n\nSeverity: {}.\n\n{}", rule->id, rule->slug, diag::severity_name(rule->severity),
                        rule->page);
  }
  return text;
}

std::string as_json() {
  nlohmann::ordered_json rules = nlohmann::ordered_json::array();
  for (const diag::RuleInfo* rule : check::catalogue()) {
    rules.push_back({{"id", rule->id},
                     {"slug", rule->slug},
                     {"severity", diag::severity_name(rule->severity)},
                     {"summary", rule->summary},
                     {"page", rule->page}});
  }
  return nlohmann::ordered_json{{"symplant-rules", 1}, {"rules", rules}}.dump(2) + "\n";
}

}  // namespace

void add_rules(CLI::App& app, Context& context) {
  auto format = std::make_shared<std::string>("md");
  CLI::App* command = app.add_subcommand("rules", "List every rule with its manual page");
  command->add_option("--format", *format, "md for people, json for programs")->check(CLI::IsMember({"md", "json"}));
  command->footer("Examples:\n  symplant rules\n  symplant rules --format json");
  command->callback([format, &context] { context.out << (*format == "json" ? as_json() : as_markdown()); });
}

}  // namespace symplant::app

// symplant explain: the manual page of a rule.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>
#include <ostream>

#include "app/commands.hpp"
#include "check/catalogue.hpp"
#include "diag/visible_text.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {

void add_explain(CLI::App& app, Context& context) {
  auto rule = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("explain", "Show the manual page of a rule");
  command->add_option("RULE", *rule, "a rule's id or slug")->required();
  command->footer("Examples:\n  symplant explain SP201\n  symplant explain wrong-number-of-levels");
  command->callback([rule, &context] {
    const diag::RuleInfo* info = check::find_rule(*rule);
    const std::string former = check::former_rule(*rule);
    if (info == nullptr) {
      context.err << "error: " << diag::visible(former.empty() ? check::no_such_rule(*rule) : former) << "\n";
      context.exit_code = host::kBadInput;
      return;
    }
    if (!former.empty()) context.err << "warning: " << former << "\n";
    context.out << "# " << info->id << " " << info->slug << "\n\n"
                << "Severity: " << diag::severity_name(info->severity) << "; " << info->summary << ".\n\n"
                << diag::manual_page(*info);
  });
}

}  // namespace symplant::app

// The tool as a function.
#include "app/tool.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <array>
#include <exception>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>

#include "app/commands.hpp"
#include "app/exit_statuses.hpp"
#include "diag/visible_text.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/tables/nearest.hpp"
#include "symplant/tables/version.hpp"

namespace symplant::app {
namespace {

constexpr std::array kCommands{&add_init,   &add_check,   &add_explain, &add_rules,  &add_generate,   &add_model,
                               &add_map,    &add_run,     &add_program, &add_doctor, &add_record,     &add_convert,
                               &add_diff,   &add_compare, &add_learn,   &add_watch,  &add_test,       &add_campaign,
                               &add_naming, &add_infer,   &add_schema,  &add_show,   &add_completion, &add_man};

/// "Exit codes: 0 good; 1 findings ...".
std::string exit_codes() {
  std::string text;
  for (const ExitStatus& status : kExitStatuses) {
    text += (text.empty() ? "Exit codes: " : "; ") + std::to_string(status.code) + " " + std::string(status.meaning);
  }
  return text + ".";
}

/// Writes a text line by line, with control characters made visible.
void report_visibly(const std::string& text, std::ostream& err) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) err << diag::visible(line) << "\n";
}

}  // namespace

namespace {

/// A first argument that is no command: CLI11 would only say that a command is missing.
bool reports_unknown_command(const CLI::App& app, int argc, char** argv, Context& context) {
  const std::string_view wanted = argc > 1 ? argv[1] : "-";
  if (wanted.starts_with('-')) return false;
  tables::NearestName nearest(wanted);
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == wanted) return false;
    nearest.offer(command->get_name());
  }
  context.err << "error: unknown command `" << diag::visible(wanted) << "`; "
              << (nearest.name().empty() ? "`symplant --help` lists all"
                                         : "did you mean `" + std::string(nearest.name()) + "`?")
              << "\n";
  return true;
}

}  // namespace

void build_commands(CLI::App& app, Context& context) {
  app.description("symplant makes running plants from PLC symbol lists, to test PLC programs against.");
  app.set_version_flag("--version", "symplant " + std::string(tables::version()));
  app.require_subcommand(1);
  app.allow_windows_style_options(false);  // `/x` is a path everywhere
  app.footer(exit_codes() + "\nThe code that symplant generates is yours.");
  for (const auto add : kCommands) add(app, context);
}

int run_tool(int argc, char** argv, Context& context) {
  CLI::App app;
  app.name("symplant");
  build_commands(app, context);
  if (reports_unknown_command(app, argc, argv, context)) return host::kBadInput;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream said;  // may contain unsafe characters of the user's arguments
    const int code = app.exit(error, context.out, said);
    report_visibly(said.str(), context.err);
    if (code == 0) return host::kGood;
    fail_run(app, error.what(), context);
    return host::kBadInput;
  } catch (const std::exception& error) {  // out of memory, or an unexpected error of a library
    context.err << "error: " << error.what() << "\n";
    return host::kEnvironment;
  }
  return context.exit_code;
}

}  // namespace symplant::app

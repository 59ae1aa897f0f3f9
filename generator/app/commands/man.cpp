// symplant man: manual pages, made from the option tree.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <memory>
#include <ostream>
#include <string>

#include "app/commands.hpp"
#include "app/man_page.hpp"
#include "app/options.hpp"
#include "diag/visible_text.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {
namespace {

void print_page(const CLI::App& tool, const std::string& name, Context& context) {
  if (name.empty()) {
    context.out << tool_page(tool);
    return;
  }
  const auto commands = visible_commands(tool);
  const auto found = std::find_if(commands.begin(), commands.end(),
                                  [&](const CLI::App* command) { return command->get_name() == name; });
  if (found == commands.end()) {
    context.err << "error: `" << diag::visible(name) << "` is not a command; `symplant --help` lists all\n";
    context.exit_code = host::kBadInput;
  } else {
    context.out << command_page(tool, **found);
  }
}

/// Ends at the first file that cannot be written.
void write_pages(const CLI::App& tool, const std::string& folder, Context& context) {
  const auto write = [&](const std::string& page, std::string text) {
    return write_result(context, folder + "/" + page + ".1", base::whole(std::move(text)), {});
  };
  if (!write(tool.get_name(), tool_page(tool))) return;
  for (const CLI::App* command : visible_commands(tool)) {
    if (!write(tool.get_name() + "-" + command->get_name(), command_page(tool, *command))) return;
  }
}

}  // namespace

void add_man(CLI::App& app, Context& context) {
  struct Options {
    std::string command;
    std::string folder;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("man", "Print the manual page of the tool or of a command");
  CLI::Option* name = command->add_option("COMMAND", options->command, "a command (default: the page of the tool)");
  command
      ->add_option("-o,--output", options->folder,
                   "write all pages to this folder: symplant.1, symplant-check.1 and others")
      ->type_name("DIR")
      ->excludes(name);
  command->footer("Examples:\n  symplant man run | man -l -\n  symplant man -o ~/.local/share/man/man1");
  command->callback([options, &app, &context] {
    if (options->folder.empty()) {
      print_page(app, options->command, context);
    } else {
      write_pages(app, options->folder, context);
    }
  });
}

}  // namespace symplant::app

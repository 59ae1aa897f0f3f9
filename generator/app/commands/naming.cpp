// symplant naming: lists the ready naming rules, or prints one.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <memory>
#include <ostream>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "diag/visible_text.hpp"
#include "naming/profiles.hpp"
#include "naming/vocabulary_text.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {
namespace {

/// "gx-works-body  device comments of GX Works: ..." for each profile.
std::string profile_list() {
  std::size_t width = 0;
  for (const naming::Profile& profile : naming::profiles()) width = std::max(width, profile.name.size());
  std::string text;
  for (const naming::Profile& profile : naming::profiles()) {
    text += fmt::format("{:<{}}  {}\n", profile.name, width, profile.summary());
  }
  return text;
}

}  // namespace

void add_naming(CLI::App& app, Context& context) {
  struct Options {
    std::string name;
    std::string output;
    bool words = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("naming", "List the ready naming rules for --naming, or print one");
  command->add_option("NAME", options->name, "a ready naming rule (default: list all)");
  command->add_option("-o,--output", options->output, "write it to this file")->type_name("FILE");
  command->add_flag("--words", options->words, "print the words that every naming rule knows, as JSON");
  command->footer(
      "To change a ready naming rule, write it to a file and edit the file.\n"
      "Examples:\n  symplant naming\n  symplant naming gx-works-body -o naming.json\n"
      "  symplant check --naming @gx-works-body symbols.csv");
  command->callback([options, &context] {
    if (options->words) {
      write_result(context, options->output, base::whole(naming::vocabulary_text()), {});
    } else if (options->name.empty()) {
      write_result(context, options->output, base::whole(profile_list()), {});
    } else if (const naming::Profile* profile = naming::find_profile(options->name)) {
      write_result(context, options->output, base::whole(std::string(profile->text())), {});
    } else {
      context.err << "error: " << diag::visible(naming::no_such_profile(options->name)) << "\n";
      context.exit_code = host::kBadInput;
    }
  });
}

}  // namespace symplant::app

// The manual pages of the tool and its commands.
#include "app/man_page.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <string_view>

#include "app/exit_statuses.hpp"
#include "app/roff.hpp"
#include "symplant/tables/version.hpp"

namespace symplant::app {
namespace {

constexpr std::string_view kExamplesHead = "Examples:\n";

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return text;
}

std::string section(const std::string& title) { return ".SH " + roff(title) + "\n"; }

/// A term with a text below it.
std::string tagged(const std::string& term, const std::string& text) { return ".TP\n" + term + "\n" + text + "\n"; }

std::string reference_to(const std::string& page) { return roff_bold(page) + "(1)"; }

/// The head of a page, with the section NAME.
std::string page_head(const std::string& page, const std::string& summary) {
  return ".TH \"" + roff(upper(page)) + "\" \"1\" \"\" \"symplant " + roff(tables::version()) +
         "\" \"symplant manual\"\n" + section("NAME") + roff(page) + " \\- " + roff(summary) + "\n";
}

bool repeats(const CLI::Option& option) { return option.get_expected_max() > 1; }

/// What the value of an option may be: `FILE`, `text|json`; empty for a flag.
std::string value_form(const CLI::Option& option) {
  if (option.get_type_size() == 0) return {};
  std::string form = option.get_type_name();
  if (form.starts_with("TEXT:")) form.erase(0, 5);
  return form.empty() ? "" : " " + roff_italic(form) + (repeats(option) ? " .\\|.\\|." : "");
}

std::string names_of(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : option.get_snames()) names += (names.empty() ? "" : ", ") + roff_bold("-" + name);
  for (const std::string& name : option.get_lnames()) names += (names.empty() ? "" : ", ") + roff_bold("--" + name);
  return names;
}

/// " Needs `--fault`." or " Excludes `--baseline`."; the names are sorted, since CLI11 keeps addresses.
std::string other_options(const std::string& verb, const std::set<CLI::Option*>& others) {
  std::set<std::string> names;
  for (const CLI::Option* other : others) names.insert(roff_bold(other->get_name()));
  std::string text;
  for (const std::string& name : names) {
    text += text.empty() ? " " + verb + " " : ", ";
    text += name;
  }
  return text.empty() ? "" : text + ".";
}

std::string option_entry(const CLI::Option& option) {
  std::string text = roff(option.get_description());
  if (!text.ends_with('.')) text += '.';
  return tagged(names_of(option) + value_form(option),
                text + other_options("Needs", option.get_needs()) + other_options("Excludes", option.get_excludes()));
}

std::vector<const CLI::Option*> positionals_of(const CLI::App& command) {
  return command.get_options(
      [](const CLI::Option* option) { return !option->get_group().empty() && option->get_positional(); });
}

/// The options of each group, under its title if there are several groups.
std::string options_section(const CLI::App& command) {
  std::string text = section("OPTIONS");
  for (const CLI::Option* option : positionals_of(command)) {
    text += tagged(roff_italic(option->get_name(true)), roff(option->get_description()) + ".");
  }
  for (const std::string& group : command.get_groups()) {
    const auto options = command.get_options(
        [&](const CLI::Option* option) { return option->get_group() == group && option->nonpositional(); });
    if (group.empty() || options.empty()) continue;
    if (group != "Options") text += ".SS " + roff(group) + "\n";
    for (const CLI::Option* option : options) text += option_entry(*option);
  }
  return text;
}

std::string synopsis(const std::string& page, const CLI::App& command) {
  std::string line = roff_bold("symplant " + command.get_name()) + " [" + roff_italic("OPTIONS") + "]";
  for (const CLI::Option* option : positionals_of(command)) {
    const std::string name = roff_italic(option->get_name(true)) + (repeats(*option) ? " .\\|.\\|." : "");
    line += option->get_required() ? " " + name : " [" + name + "]";
  }
  return page + section("SYNOPSIS") + line + "\n";
}

std::string exit_section() {
  std::string text = section("EXIT STATUS");
  for (const ExitStatus& status : kExitStatuses) {
    text += tagged(roff_bold(std::to_string(status.code)), roff(status.meaning) + ".");
  }
  return text;
}

/// The lines below "Examples:" of a help text, without their indentation.
std::string examples_section(const std::string& footer) {
  const auto head = footer.find(kExamplesHead);
  if (head == std::string::npos) return {};
  std::string text = section("EXAMPLES") + ".nf\n";
  std::istringstream lines(footer.substr(head + kExamplesHead.size()));
  for (std::string line; std::getline(lines, line);) {
    text += roff(line.starts_with("  ") ? line.substr(2) : line) + "\n";
  }
  return text + ".fi\n";
}

/// What a help text says before its examples, as a paragraph.
std::string remarks(const std::string& footer) {
  const std::string text = footer.substr(0, footer.find(kExamplesHead));
  return text.empty() ? "" : ".PP\n" + roff(text.substr(0, text.find_last_not_of('\n') + 1)) + "\n";
}

std::string command_list(const CLI::App& tool) {
  std::string text = section("COMMANDS");
  for (const CLI::App* command : visible_commands(tool)) {
    text += tagged(reference_to("symplant-" + command->get_name()), roff(command->get_description()) + ".");
  }
  return text;
}

}  // namespace

std::vector<const CLI::App*> visible_commands(const CLI::App& tool) {
  return tool.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::string tool_page(const CLI::App& tool) {
  std::string related = section("SEE ALSO");
  const auto commands = visible_commands(tool);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    related += reference_to("symplant-" + commands[i]->get_name()) + (i + 1 < commands.size() ? ",\n" : "\n");
  }
  return page_head("symplant", "running plants from PLC symbol lists") + section("SYNOPSIS") + roff_bold("symplant") +
         " " + roff_italic("COMMAND") + " [" + roff_italic("OPTIONS") + "] " + roff_italic("ARGUMENTS") + "\n" +
         section("DESCRIPTION") + roff(tool.get_description()) + "\n.PP\n" + roff_bold("symplant man") + " " +
         roff_italic("COMMAND") + " prints the page of a command.\n" + command_list(tool) + options_section(tool) +
         exit_section() + related;
}

std::string command_page(const CLI::App& tool, const CLI::App& command) {
  const std::string page = tool.get_name() + "-" + command.get_name();
  const std::string footer = command.get_footer();
  return synopsis(page_head(page, command.get_description()), command) + section("DESCRIPTION") +
         roff(command.get_description()) + ".\n" + remarks(footer) + options_section(command) + exit_section() +
         examples_section(footer) + section("SEE ALSO") + reference_to(tool.get_name()) + "\n";
}

}  // namespace symplant::app

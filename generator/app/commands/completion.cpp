// symplant completion: scripts for bash and zsh, made from the option tree.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>
#include <string>

#include "app/commands.hpp"
#include "app/options.hpp"

namespace symplant::app {
namespace {

std::string long_options(const CLI::App& command) {
  std::string names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names += (names.empty() ? "--" : " --") + name;
  }
  return names;
}

/// The body of a shell `case` over the commands: their options.
std::string cases(const CLI::App& app) {
  std::string text;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    text += "    " + command->get_name() + ") options=\"" + long_options(*command) + "\" ;;\n";
  }
  return text;
}

std::string command_names(const CLI::App& app) {
  std::string text;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    text += (text.empty() ? "" : " ") + command->get_name();
  }
  return text;
}

std::string bash(const CLI::App& app) {
  return "# bash completion for symplant: put this line into ~/.bashrc:\n#   source <(symplant completion bash)\n"
         "_symplant() {\n  local word=\"${COMP_WORDS[COMP_CWORD]}\" command=\"${COMP_WORDS[1]}\" options=\"\"\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n    mapfile -t COMPREPLY < <(compgen -W \"" +
         command_names(app) + " " + long_options(app) + "\" -- \"$word\")\n    return\n  fi\n  case \"$command\" in\n" +
         cases(app) +
         "  esac\n  case \"$word\" in\n    -*) mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$word\") ;;\n"
         "    *) mapfile -t COMPREPLY < <(compgen -f -- \"$word\") ;;\n  esac\n}\ncomplete -o filenames -F _symplant "
         "symplant\n";
}

std::string zsh(const CLI::App& app) {
  return "#compdef symplant\n# zsh completion for symplant: put this line into ~/.zshrc, after compinit:\n"
         "#   source <(symplant completion zsh)\n_symplant() {\n  local options=\"\"\n  if (( CURRENT == 2 )); then\n"
         "    compadd -- " +
         command_names(app) + " " + long_options(app) + "\n    return\n  fi\n  case \"${words[2]}\" in\n" + cases(app) +
         "  esac\n  if [[ \"${words[CURRENT]}\" == -* ]]; then\n    compadd -- ${=options}\n  else\n    _files\n  "
         "fi\n}\n"
         "if [[ \"${funcstack[1]}\" == _symplant ]]; then  # a file of $fpath, loaded by its first use\n  _symplant "
         "\"$@\"\nelse\n"
         "  compdef _symplant symplant\nfi\n";
}

}  // namespace

void add_completion(CLI::App& app, Context& context) {
  struct Options {
    std::string shell;
    std::string output;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("completion", "Print a completion script for a shell");
  command->add_option("SHELL", options->shell, "bash or zsh")->required()->check(CLI::IsMember({"bash", "zsh"}));
  command->add_option("-o,--output", options->output, "write it to this file")->type_name("FILE");
  command->footer("Examples:\n  source <(symplant completion bash)\n  symplant completion zsh -o ~/.zfunc/_symplant");
  command->callback([options, &app, &context] {
    write_result(context, options->output, base::whole(options->shell == "bash" ? bash(app) : zsh(app)), {});
  });
}

}  // namespace symplant::app

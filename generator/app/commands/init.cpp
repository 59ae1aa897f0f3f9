// symplant init: writes a first plant description.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <memory>
#include <ostream>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "emit/skeleton.hpp"
#include "symplant/host/exit_codes.hpp"
#include "text/encoding.hpp"

namespace symplant::app {
namespace {

struct InitOptions {
  std::string list;
  PlantOptions plant_options;
  std::string output;
  bool force = false;
};

/// The path of a file relative to the folder of the description, with `/`, which every system accepts.
std::string list_from(const std::string& output, const std::string& list) {
  namespace fs = std::filesystem;
  std::error_code unknown;
  const fs::path folder = fs::absolute(output, unknown).lexically_normal().parent_path();
  const fs::path relative = fs::absolute(list, unknown).lexically_normal().lexically_relative(folder);
  return (relative.empty() ? fs::path(list) : relative).generic_string();
}

emit::SkeletonList reference(const InitOptions& options) {
  const PlantOptions& given = options.plant_options;
  emit::SkeletonList list;
  list.file = options.output.empty() ? options.list : list_from(options.output, options.list);
  list.format = given.read.input_format;
  if (given.read.encoding) list.encoding = text::encoding_name(*given.read.encoding);
  list.naming = given.naming;
  if (!list.naming.empty() && !list.naming.starts_with('@') && !options.output.empty()) {
    list.naming = list_from(options.output, given.naming);
  }
  if (given.xy) list.xy = *given.xy == address::Radix::hexadecimal ? "hex" : "octal";
  return list;
}

void init(const InitOptions& options, Context& context) {
  if (!options.output.empty() && !options.force && context.files.read(options.output)) {
    context.err << "error: `" << options.output
                << "` already exists, and may contain your work: name another file, or use --force\n";
    context.exit_code = host::kBadInput;
    return;
  }
  const auto compiled = compile_for(context, options.list, options.plant_options);
  if (!compiled) return;
  if (compiled->plant.description_source != nullptr) {
    context.err << "error: `" << options.list << "` is a plant description already: name the symbol list\n";
    context.exit_code = host::kBadInput;
    return;
  }
  write_result(context, options.output,
               base::whole(emit::skeleton(compiled->plant, compiled->evidence, reference(options))), {options.list});
}

}  // namespace

void add_init(CLI::App& app, Context& context) {
  auto options = std::make_shared<InitOptions>();
  CLI::App* command = app.add_subcommand("init", "Write a first plant.json: inferred facts, and keys worth giving");
  command->add_option("LIST", options->list, "a symbol list")->required();
  command
      ->add_option("-o,--output", options->output,
                   "write it to this file, which must not exist (default: standard output)")
      ->type_name("FILE");
  command->add_flag("--force", options->force, "overwrite the file");
  add_plant_options(*command, options->plant_options);
  command->footer(
      "The description is valid as it is. To set a key, remove the `//` before it.\n"
      "Examples:\n  symplant init symbols.csv -o plant.json\n  symplant init symbols.csv | less");
  command->callback([options, &context] { init(*options, context); });
}

}  // namespace symplant::app

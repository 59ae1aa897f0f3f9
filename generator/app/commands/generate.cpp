// symplant generate: the plant as C++.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <filesystem>
#include <memory>
#include <ostream>

#include "app/commands.hpp"
#include "app/depfile.hpp"
#include "app/generate_fmu.hpp"
#include "app/options.hpp"
#include "emit/emit.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {
namespace {

struct GenerateOptions {
  std::string plant;
  PlantOptions plant_options;
  std::string folder;
  std::string fmu;
  std::vector<std::string> fmu_libraries;
  std::string depfile;
  std::string templates;
  std::string behaviours;
  bool check = false;
};

std::string in_folder(const GenerateOptions& options, const std::string& name) {
  return (std::filesystem::path(options.folder) / name).generic_string();
}

std::string own_path(const GenerateOptions& options, const emit::OwnFile& file) {
  return (std::filesystem::path(options.behaviours) / file.name).generic_string();
}

/// --behaviours: writes the missing files of the user, and leaves the others unchanged. False if writing fails.
bool write_own(const GenerateOptions& options, const emit::EmitResult& emitted, Context& context) {
  if (options.behaviours.empty()) return true;
  if (emitted.own_files.empty()) {
    context.err << "note: no device has a `behaviour`: nothing is written to `" << options.behaviours << "`\n";
  }
  for (const emit::OwnFile& file : emitted.own_files) {
    const auto written = context.files.write_new(own_path(options, file), file.content);
    if (!written) {
      context.err << "error: " << written.error().message << "\n";
      context.exit_code = host::kEnvironment;
      return false;
    }
    if (*written) context.out << own_path(options, file) << ": written for you to fill in\n";
  }
  return true;
}

/// --check: reports files that are missing or differ, writes nothing.
void compare(const GenerateOptions& options, const emit::EmitResult& emitted, Context& context) {
  for (const emit::EmittedFile& file : emitted.files) {
    const std::string path = in_folder(options, file.name);
    if (context.files.holds(path, file.content)) continue;
    context.out << path << (context.files.exists(path) ? " is out of date" : " is missing") << "\n";
    context.exit_code = host::kFindings;
  }
  for (const emit::OwnFile& file : emitted.own_files) {
    if (options.behaviours.empty() || context.files.exists(own_path(options, file))) continue;
    context.out << own_path(options, file) << " is missing\n";
    context.exit_code = host::kFindings;
  }
  const bool good = context.exit_code == host::kGood;
  context.out << (good ? "up to date: " : "") << options.folder
              << (good ? "\n" : " is out of date: run `symplant generate` again\n");
}

void write(const GenerateOptions& options, const emit::EmitResult& emitted, std::vector<std::string> inputs,
           Context& context) {
  if (!write_own(options, emitted, context)) return;
  std::size_t changed = 0;
  for (const emit::EmittedFile& file : emitted.files) {
    const auto written = context.files.write_made(in_folder(options, file.name), file.content);
    if (!written) {
      context.err << "error: " << written.error().message << "\n";
      context.exit_code = host::kEnvironment;
      return;
    }
    if (*written) ++changed;
  }
  if (!options.depfile.empty()) {  // last: when it exists, all other files do
    const std::vector<std::string> plant_files = inputs;
    inputs.insert(inputs.end(), emitted.inputs.begin(), emitted.inputs.end());
    if (!options.templates.empty()) inputs.push_back(options.templates);  // its time changes if a template is added
    const std::string rule = depfile(in_folder(options, "tables_gen.cpp"), inputs);
    if (!write_result(context, options.depfile, base::whole(rule), plant_files)) return;
  }
  context.out << fmt::format("{}: {} files, {} of them new or changed\n", options.folder, emitted.files.size(),
                             changed);
}

bool has_templates(const GenerateOptions& options, Context& context) {
  std::error_code unknown;
  if (options.templates.empty() || std::filesystem::is_directory(options.templates, unknown)) return true;
  context.err << "error: `" << options.templates << "` is not a folder: give the folder with your templates\n";
  context.exit_code = host::kBadInput;
  return false;
}

void generate_code(const GenerateOptions& options, const Compiled& compiled, Context& context) {
  if (!has_templates(options, context)) return;
  const emit::EmitResult emitted = emit::emit(compiled.plant, compiled.tables, {options.templates}, context.files);
  if (!emitted.errors.empty()) {
    for (const std::string& error : emitted.errors) context.err << "error: " << error << "\n";
    context.exit_code = host::kBadInput;
    return;
  }
  if (options.check) {
    compare(options, emitted, context);
  } else {
    write(options, emitted, compiled.plant.input_files(), context);
  }
}

void generate(const GenerateOptions& options, Context& context) {
  if (options.folder.empty() && options.fmu.empty()) {
    context.err << "error: give `-o DIR` for C++, or `--fmu FILE` for an FMU\n";
    context.exit_code = host::kBadInput;
    return;
  }
  auto made = compile_for(context, options.plant, options.plant_options);
  if (!made) return;
  const auto compiled = std::make_shared<const Compiled>(std::move(*made));
  context.kept = compiled;
  if (options.fmu.empty()) {
    generate_code(options, *compiled, context);
  } else {
    generate_fmu({options.fmu, options.fmu_libraries, options.depfile, options.check}, *compiled, context);
  }
}

}  // namespace

void add_generate(CLI::App& app, Context& context) {
  auto options = std::make_shared<GenerateOptions>();
  CLI::App* command = app.add_subcommand("generate", "Write the plant as C++, or as an FMU for co-simulation");
  command->add_option("PLANT", options->plant, "a plant.json or a symbol list")->required();
  CLI::Option* const folder = command
                                  ->add_option("-o,--output-dir", options->folder,
                                               "the folder for C++ classes, tables, a main and a CMakeLists.txt")
                                  ->type_name("DIR");
  CLI::Option* const fmu =
      command->add_option("--fmu", options->fmu, "the file for the plant as an FMU (FMI 2.0, co-simulation)")
          ->type_name("FILE")
          ->excludes(folder);
  command->add_option("--depfile", options->depfile, "write what the files were made from, for make and ninja")
      ->type_name("FILE");
  command->add_option("--templates", options->templates, "a folder with templates that replace the built-in ones")
      ->type_name("DIR")
      ->needs(folder);
  command
      ->add_option("--behaviours", options->behaviours,
                   "the folder of your behavior classes: missing ones are written there, once")
      ->type_name("DIR")
      ->needs(folder);
  command
      ->add_option(
          "--fmu-library", options->fmu_libraries,
          "a library for the FMU instead of all that the tool has: `linux64=FILE`, `win64=FILE`; several are possible")
      ->type_name("PLATFORM=FILE")
      ->needs(fmu);
  command->add_flag("--check", options->check, "write nothing; exit code 1 if the folder or the FMU is out of date");
  add_plant_options(*command, options->plant_options);
  command->footer(
      "The generated code is yours: the license of symplant does not extend to it.\n"
      "Examples:\n  symplant generate plant.json -o plant\n  symplant generate symbols.csv -o plant --check\n"
      "  symplant generate plant.json -o plant --behaviours behaviours\n"
      "  symplant generate plant.json --fmu plant.fmu");
  command->callback([options, &context] { generate(*options, context); });
}

}  // namespace symplant::app

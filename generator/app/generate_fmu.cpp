// symplant generate --fmu.
#include "app/generate_fmu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <optional>
#include <ostream>

#include "app/depfile.hpp"
#include "app/options.hpp"
#include "emit/emit.hpp"
#include "fmu/package.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::app {
namespace {

void fail(Context& context, int exit_code, const std::string& message) {
  context.err << "error: " << message << "\n";
  context.exit_code = exit_code;
}

/// The libraries of an FMU, with the texts that they refer to.
struct Libraries {
  std::vector<fmu::Library> all;
  std::deque<std::string> texts;
  std::vector<std::string> files;
};

/// Those of the tool, or only those of the user if there are any. Nothing, with a message, if one cannot be read.
std::optional<Libraries> libraries_of(const FmuOptions& options, Context& context) {
  Libraries libraries;
  for (const std::string& given : options.libraries) {
    const std::size_t equals = given.find('=');
    if (equals == std::string::npos || equals == 0) {
      fail(context, host::kBadInput, "`--fmu-library " + given + "`: give PLATFORM=FILE, such as `win64=plant.dll`");
      return std::nullopt;
    }
    const std::string file = given.substr(equals + 1);
    auto bytes = context.files.read(file);
    if (!bytes) {
      fail(context, host::kBadInput, bytes.error().message);
      return std::nullopt;
    }
    const std::string& platform = libraries.texts.emplace_back(given.substr(0, equals));
    const auto is_same = [&](const fmu::Library& library) { return library.platform == platform; };
    if (std::any_of(libraries.all.begin(), libraries.all.end(), is_same)) {
      fail(context, host::kBadInput, "`--fmu-library` has two files for " + platform + ": give one");
      return std::nullopt;
    }
    const std::string& extension = libraries.texts.emplace_back(std::filesystem::path(file).extension().string());
    libraries.all.push_back({platform, extension, libraries.texts.emplace_back(std::move(*bytes))});
    libraries.files.push_back(file);
  }
  // A library of the user may have C++ that those of the tool do not have: they are never mixed.
  if (options.libraries.empty()) libraries.all.assign(fmu::libraries().begin(), fmu::libraries().end());
  return libraries;
}

/// Whether the FMU has no C++ of the user that it needs; otherwise reports it.
bool needs_no_code(const FmuOptions& options, const tables::PlantTables& tables, Context& context) {
  if (tables.behaviour_units.empty() || !options.libraries.empty()) return true;
  const tables::BehaviourUnit& first = tables.behaviour_units.front();
  fail(context, host::kBadInput,
       fmt::format("`{}` has the custom behavior `{}`, which is C++: build the FMU with symplant_add_fmu() in CMake "
                   "(docs/fmi.md)",
                   tables::split_names(tables.unit_names)[first.unit],
                   tables::split_names(tables.behaviour_names)[first.name]));
  return false;
}

}  // namespace

void generate_fmu(const FmuOptions& options, const Compiled& compiled, Context& context) {
  const tables::PlantTables tables = compiled.tables.tables();
  if (!needs_no_code(options, tables, context)) return;
  const auto libraries = libraries_of(options, context);
  if (!libraries) return;
  const auto packed = fmu::package(compiled.plant, tables, emit::namespace_of(compiled.tables.name), libraries->all);
  if (!packed) return fail(context, host::kBadInput, packed.error().message);
  if (options.check) {
    const bool good = context.files.holds(options.file, base::whole(*packed));
    context.out << (good ? "up to date: " : "") << options.file
                << (good ? "\n" : " is out of date: run `symplant generate` again\n");
    if (!good) context.exit_code = host::kFindings;
    return;
  }
  const std::vector<std::string> plant_files = compiled.plant.input_files();
  std::vector<std::string> inputs = plant_files;
  inputs.insert(inputs.end(), libraries->files.begin(), libraries->files.end());
  if (!write_result(context, options.file, base::whole(*packed), inputs)) return;
  if (!options.depfile.empty() &&
      !write_result(context, options.depfile, base::whole(depfile(options.file, inputs)), inputs)) {
    return;
  }
  std::string platforms;
  for (const fmu::Library& library : libraries->all)
    platforms.append(platforms.empty() ? "" : ", ").append(library.platform);
  context.out << fmt::format("{}: FMI 2.0 for co-simulation, {} kB, for {}\n", options.file, packed->size() / 1000,
                             platforms);
}

}  // namespace symplant::app

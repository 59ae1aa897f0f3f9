// symplant generate --fmu.
#include "app/generate_fmu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
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

bool is_of(std::string_view platform, std::string_view system) { return platform.substr(0, system.size()) == system; }

/// How the libraries of a platform's system end and begin.
std::string_view extension_of(std::string_view platform) {
  return is_of(platform, "win") ? ".dll" : is_of(platform, "darwin") ? ".dylib" : ".so";
}
bool is_library(std::string_view platform, std::string_view bytes) {
  if (is_of(platform, "darwin")) return !bytes.empty();
  const std::string_view begin = is_of(platform, "win") ? "MZ"
                                                        : "\x7F"
                                                          "ELF";
  return bytes.substr(0, begin.size()) == begin;
}

/// Reads a library of the user, `PLATFORM=FILE`. Returns what is wrong with it; empty: nothing.
std::string add_library(const std::string& given, const base::FileSystem& files, Libraries& libraries) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  const std::size_t equals = given.find('=');
  const std::string platform = given.substr(0, equals);
  if (equals == std::string::npos || platform.empty() || platform.find_first_not_of(kLetters) != std::string::npos) {
    return "`--fmu-library " + given + "`: give PLATFORM=FILE, such as `win64=plant.dll`";
  }
  const std::string file = given.substr(equals + 1);
  auto bytes = files.read(file);
  if (!bytes) return bytes.error().message;
  if (!is_library(platform, *bytes)) return "`" + file + "` is not a shared library for " + platform;
  const auto is_same = [&](const fmu::Library& library) { return library.platform == platform; };
  if (std::any_of(libraries.all.begin(), libraries.all.end(), is_same)) {
    return "`--fmu-library` has two files for " + platform + ": give one";
  }
  const std::string& kept = libraries.texts.emplace_back(platform);
  libraries.all.push_back({kept, extension_of(kept), libraries.texts.emplace_back(std::move(*bytes))});
  libraries.files.push_back(file);
  return {};
}

/// Those of the tool, or only those of the user if there are any. Nothing, with a message, if one is not a library.
std::optional<Libraries> libraries_of(const FmuOptions& options, Context& context) {
  Libraries libraries;
  for (const std::string& given : options.libraries) {
    if (const std::string fault = add_library(given, context.files, libraries); !fault.empty()) {
      fail(context, host::kBadInput, fault);
      return std::nullopt;
    }
  }
  // A library of the user may have C++ that those of the tool do not have: they are never mixed.
  if (options.libraries.empty()) libraries.all.assign(fmu::libraries().begin(), fmu::libraries().end());
  return libraries;
}

/// Whether the plant needs none of the user's C++, or the user gave libraries; otherwise reports it.
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

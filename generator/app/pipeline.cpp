// The whole road of the tool.
#include "app/pipeline.hpp"

#include <filesystem>

#include "check/check_plant.hpp"
#include "lower/lower.hpp"
#include "model/build_plant.hpp"
#include "name/named_table.hpp"
#include "name/naming_rule.hpp"

namespace symplant::app {

std::optional<model::PlantModel> analyse(const CompileOptions& options, const base::FileSystem& files,
                                         Progress& progress, diag::Diagnostics& diagnostics) {
  progress.stage("reading " + options.list);
  auto table = read::read_symbol_list(options.list, options.read, files, diagnostics);
  if (!table) return std::nullopt;
  const auto list = std::make_shared<const read::SymbolTable>(std::move(*table));

  progress.stage("reading names");
  const name::NamedTable named = name::read_names(*list, name::built_in_rule());

  progress.stage("deriving models");
  model::PlantModel plant =
      model::build_plant(list, named, {std::filesystem::path(options.list).stem().string(), options.xy});

  progress.stage("checking");
  check::check_plant(plant, diagnostics);
  diagnostics.sort_by_place();
  return plant;
}

std::optional<Compiled> compile(const CompileOptions& options, const base::FileSystem& files, Progress& progress,
                                diag::Diagnostics& diagnostics) {
  auto plant = analyse(options, files, progress, diagnostics);
  if (!plant || diagnostics.has_errors()) return std::nullopt;
  progress.stage("lowering");
  lower::EngineTables tables = lower::lower(*plant);
  return Compiled{std::move(*plant), std::move(tables)};
}

}  // namespace symplant::app

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
  name::NamedTable named = name::read_names(*list, name::built_in_rule());

  progress.stage("deriving models");
  std::vector<model::ListInput> lists;
  lists.push_back({list, std::move(named), {}, options.xy});
  model::PlantModel plant = model::build_plant(lists, {std::filesystem::path(options.list).stem().string()});

  progress.stage("checking");
  check::check_plant(plant, diagnostics);
  diagnostics.sort_by_place(plant.sources());
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

// The plant as C++ files.
#include "emit/emit.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/identifier.hpp"
#include "emit/encode.hpp"
#include "emit/keys.hpp"
#include "emit/render.hpp"
#include "emit/rows.hpp"
#include "emit/table_views.hpp"
#include "emit/taken_namespaces.hpp"
#include "emit/type_view.hpp"
#include "symplant/core/version.hpp"

namespace symplant::emit {
namespace {

View plant_view(const model::PlantModel& plant, const lower::EngineTables& tables) {
  const std::vector<std::string> classes = class_names(tables, plant);
  View view;
  auto& texts = view.texts;
  texts["version"] = core::version();
  texts["version_required"] = fmt::format("{}.{}", core::kVersionMajor, core::kVersionMinor);
  texts["tables_version"] = std::to_string(core::kTablesVersion);
  texts["list"] = comment_text(plant.list_names());
  texts["plant"] = comment_text(tables.name);
  texts["namespace"] = namespace_of(tables.name);
  texts["open"] = "{";
  texts["close"] = "}";
  texts["unit_count"] = std::to_string(tables.units.size());
  texts["symbol_count"] = std::to_string(tables.symbols.size());
  texts["type_count"] = std::to_string(tables.types.size());
  texts["device_rows"] = device_rows(plant);
  texts["symbol_constant_rows"] = symbol_constant_rows(plant);
  texts["type_rows"] = type_rows(classes, texts["namespace"]);
  texts["link_count"] = std::to_string(plant.description->links.size());
  texts["link_rows"] = link_rows(*plant.description);
  texts["kind_rows"] = kind_rows(tables);
  add_tables(view, tables, plant);
  view.lists["types"] = type_views(tables, plant, classes);
  return view;
}

}  // namespace

std::string namespace_of(const std::string& plant_name) {
  std::string words = plant_name;  // what parts words in file names reads best as `_`
  for (char& c : words) {
    if (c == ' ' || c == '-' || c == '.') c = '_';
  }
  base::IdentifierScope scope(kTakenNamespaces);
  return scope.unique(words);
}

EmitResult emit(const model::PlantModel& plant, const lower::EngineTables& tables, const EmitOptions& options,
                const base::FileSystem& files) {
  EmitResult result;
  const View view = plant_view(plant, tables);
  for (const Template& own : embedded_templates()) {
    Template used = own;
    std::string path = "the tool's own template " + std::string(own.name);
    std::string text;
    if (!options.templates_folder.empty()) {
      const auto file = std::filesystem::path(options.templates_folder) / (std::string(own.name) + ".mustache");
      std::error_code ignored;
      if (std::filesystem::exists(file, ignored)) {
        path = file.string();
        auto read = files.read(path);
        if (!read) {
          result.errors.push_back(read.error().message);
          continue;
        }
        text = std::move(*read);
        used.text = text;
        result.inputs.push_back(path);
      }
    }
    auto rendered = render(used, view);
    if (rendered) {
      result.files.push_back({std::string(own.name), std::move(*rendered)});
    } else {
      result.errors.push_back(fmt::format("{}:{}: {}", path, rendered.error().line, rendered.error().message));
    }
  }
  return result;
}

}  // namespace symplant::emit

// The plant as C++ files.
#include "emit/emit.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "base/identifier.hpp"
#include "emit/encode.hpp"
#include "emit/keys.hpp"
#include "emit/render.hpp"
#include "emit/rows.hpp"
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
  texts["list"] = comment_text(tables.list);
  texts["plant"] = comment_text(tables.name);
  texts["namespace"] = namespace_of(tables.name);
  texts["open"] = "{";
  texts["close"] = "}";
  texts["plant_literal"] = string_literal(tables.name);
  texts["list_literal"] = string_literal(tables.list);
  const std::pair<const char*, std::size_t> counts[] = {{"unit_count", tables.units.size()},
                                                        {"symbol_count", tables.symbols.size()},
                                                        {"type_count", tables.types.size()},
                                                        {"time_count", tables.times.size()},
                                                        {"initial_count", tables.initial_values.size()},
                                                        {"shared_count", tables.shared_addresses.size()},
                                                        {"operation_bits", tables.operation_bits},
                                                        {"event_bits", tables.event_bits},
                                                        {"operation_slots", tables.operation_slots},
                                                        {"event_slots", tables.event_slots}};
  for (const auto& [key, count] : counts) texts[key] = std::to_string(count);
  texts["device_rows"] = device_rows(plant);
  texts["symbol_constant_rows"] = symbol_constant_rows(plant);
  texts["type_rows"] = type_rows(classes, texts["namespace"]);
  texts["unit_rows"] = unit_rows(tables, plant);
  texts["time_rows"] = time_rows(tables);
  texts["kind_rows"] = kind_rows(tables);
  texts["symbol_rows"] = symbol_rows(tables, plant);
  texts["initial_rows"] = initial_rows(tables);
  texts["shared_rows"] = shared_rows(tables);
  texts["unit_names"] = name_rows(tables.unit_names, 1);
  texts["state_names"] = name_rows(tables.state_names, 8);
  texts["symbol_names"] = name_rows(tables.symbol_names, 2);
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

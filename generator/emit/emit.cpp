// The plant as C++ files.
#include "emit/emit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "elements/alarm/resolve.hpp"
#include "elements/link/rows.hpp"
#include "elements/malfunction/rows.hpp"
#include "elements/material/rows.hpp"
#include "elements/scene/rows.hpp"
#include "elements/value/functions.hpp"
#include "emit/accessors.hpp"
#include "emit/behaviour_view.hpp"
#include "emit/encode.hpp"
#include "emit/keys.hpp"
#include "emit/render.hpp"
#include "emit/rows.hpp"
#include "emit/table_views.hpp"
#include "emit/taken_namespaces.hpp"
#include "emit/type_view.hpp"
#include "symplant/tables/version.hpp"
#include "text/identifier.hpp"

namespace symplant::emit {
namespace {

void add_rows(View& view, const std::string& key, bool any, RowSource source) {
  if (any) {
    view.rows[key] = std::move(source);
  } else {
    view.texts[key];
  }
}

/// The class from which that of the plant is derived.
void add_base(View& view, const model::PlantModel& plant) {
  const bool parts = !plant.material.empty();
  std::string base = parts ? "PartsPlant" : "NamedPlant";
  std::string arguments = parts ? "Symbol, Location, PartKind" : "Symbol";
  if (!plant.malfunctions.empty()) {
    arguments = fmt::format("symplant::plant::{}<{}>, Malfunction", base, arguments);
    base = "MalfunctionsPlant";
  }
  view.texts["plant_base"] = std::move(base);
  view.texts["plant_arguments"] = std::move(arguments);
  view.lists["malfunctions"];
  if (plant.malfunctions.empty()) return;
  view.lists["malfunctions"].push_back({{{"malfunction_constant_rows", malfunction_constant_rows(plant)}}, {}});
}

/// Names of locations and kinds, if there are any.
void add_parts(View& view, const model::Material& material) {
  view.lists["parts"];
  if (material.empty()) return;
  view.lists["parts"].push_back({{{"location_constant_rows", location_constant_rows(material)},
                                  {"part_kind_constant_rows", part_kind_constant_rows(material)}},
                                 {}});
}

/// The functions of the formulas, if there are any.
void add_formulas(View& view, const model::PlantModel& plant, const lower::EngineTables& tables) {
  view.lists["formulas"];
  if (tables.values.formulas.empty()) return;
  view.lists["formulas"].push_back({{{"formula_function_rows", formula_function_rows(tables, plant)},
                                     {"formula_entry_rows", formula_entry_rows(tables, plant)}},
                                    {}});
}

View plant_view(const model::PlantModel& plant, const lower::EngineTables& tables) {
  const std::vector<std::string> classes = class_names(tables, plant);
  View view;
  auto& texts = view.texts;
  texts["version"] = tables::version();
  texts["version_required"] = fmt::format("{}.{}", tables::kVersionMajor, tables::kVersionMinor);
  texts["tables_version"] = std::to_string(tables::kTablesVersion);
  texts["list"] = comment_text(plant.list_names());
  texts["plant"] = comment_text(tables.name);
  texts["namespace"] = namespace_of(tables.name);
  texts["open"] = "{";
  texts["close"] = "}";
  texts["unit_count"] = std::to_string(tables.units.size());
  texts["symbol_count"] = std::to_string(tables.symbols.size());
  texts["random_time_count"] = std::to_string(tables.random_times.size());
  texts["type_count"] = std::to_string(tables.types.size());
  Accessors by_name = accessors(tables, plant, classes, texts["namespace"]);
  add_rows(view, "group_rows", !plant.units.empty(), std::move(by_name.groups));
  add_rows(view, "accessor_rows", !plant.units.empty() || !plant.values.empty(), std::move(by_name.plant));
  add_rows(view, "symbol_constant_rows", !plant.symbols.empty(),
           [&tables](RowWriter& rows) { symbol_constant_rows(rows, tables); });
  add_base(view, plant);
  add_parts(view, plant.material);
  add_formulas(view, plant, tables);
  texts["type_rows"] = type_rows(tables, plant, classes, texts["namespace"]);
  texts["link_count"] = std::to_string(plant.description->links.size());
  texts["link_rows"] = link_rows(*plant.description);
  texts["ignored_count"] = std::to_string(ignored_findings(*plant.description).size());
  texts["ignored_rows"] = ignored_rows(*plant.description);
  view.lists["programs"];
  if (const auto& programs = plant.description->programs; !programs.empty()) {
    view.lists["programs"].push_back({{{"program_count", std::to_string(programs.size())},
                                       {"ignored_variables", ignored_variables(*plant.description)},
                                       {"program_rows", program_rows(*plant.description)}},
                                      {}});
  }
  view.lists["view"];
  if (const model::Layout layout = model::has_layout(plant) ? model::layout_of(plant) : model::Layout();
      !layout.devices.empty()) {
    view.lists["view"].push_back({{{"device_view_count", std::to_string(layout.devices.size())},
                                   {"device_view_rows", device_view_rows(layout)},
                                   {"station_rows", station_rows(layout)}},
                                  {}});
  }
  view.lists["symbol_views"];
  if (std::string rows = symbol_view_rows(plant); !rows.empty()) {
    view.lists["symbol_views"].push_back(
        {{{"symbol_view_count", std::to_string(plant.symbols.size())}, {"symbol_view_rows", std::move(rows)}}, {}});
  }
  view.lists["alarm_views"];
  if (const std::vector<model::Alarm> alarms = model::alarms_by_output(plant); !alarms.empty()) {
    view.lists["alarm_views"].push_back(
        {{{"alarm_view_count", std::to_string(alarms.size())}, {"alarm_view_rows", alarm_view_rows(alarms, plant)}},
         {}});
  }
  view.lists["shapes"];
  if (std::string rows = shape_rows(plant); !rows.empty()) {
    view.lists["shapes"].push_back({{{"shape_rows", std::move(rows)}}, {}});
  }
  view.lists["plan"];
  view.lists["view3d"];
  const description::GivenScene& scene = plant.description->scene;
  if (!scene.plan.empty()) view.lists["plan"].push_back({{{"plan_rows", json_rows(scene.plan)}}, {}});
  if (!scene.view3d.empty()) view.lists["view3d"].push_back({{{"view3d_rows", json_rows(scene.view3d)}}, {}});
  texts["controller_count"] = std::to_string(plant.links.size());
  texts["place_arrays"] = place_arrays(plant);
  texts["link_settings_rows"] = link_settings_rows(plant);
  texts["kind_rows"] = kind_rows(tables);
  add_tables(view, tables, plant);
  view.lists["types"] = type_views(tables, plant, classes);
  view.lists["behaviours"] = behaviour_views(tables, plant, classes);
  view.lists["view_includes"];
  view.lists["own_code"];
  if (!view.lists["behaviours"].empty()) {
    view.lists["view_includes"].push_back({{{"include", "symplant/plant/device_view.hpp"}}, {}});
    view.lists["own_code"].emplace_back();
  }
  return view;
}

}  // namespace

std::string namespace_of(const std::string& plant_name) {
  std::string words = plant_name;  // separators in file names become `_`
  for (char& c : words) {
    if (c == ' ' || c == '-' || c == '.') c = '_';
  }
  text::IdentifierScope scope(kTakenNamespaces);
  return scope.unique(words);
}

namespace {

/// The template of one file: the built-in one, or the user's that replaces it.
struct Frame {
  std::string path;  ///< for messages
  std::string text;
};

std::optional<Frame> frame_of(const Template& own, const EmitOptions& options, const base::FileSystem& files,
                              EmitResult& result) {
  const auto file = std::filesystem::path(options.templates_folder) / (std::string(own.name) + ".mustache");
  std::error_code ignored;
  if (options.templates_folder.empty() || (!own.text.empty() && !std::filesystem::exists(file, ignored))) {
    return Frame{"the built-in template " + std::string(own.name), std::string(own.text)};
  }
  auto read = files.read(file.generic_string());
  if (!read) {
    result.errors.push_back(read.error().message);
    return std::nullopt;
  }
  result.inputs.push_back(file.generic_string());
  return Frame{file.generic_string(), std::move(*read)};
}

/// The filled template. Nothing, and an error in `result`, if the template has a fault.
std::optional<base::TextSource> filled(std::string_view name, const Frame& frame, const View& view,
                                       EmitResult& result) {
  auto rendered = render({name, frame.text}, view);
  if (rendered) return std::move(*rendered);
  result.errors.push_back(fmt::format("{}:{}: {}", frame.path, rendered.error().line, rendered.error().message));
  return std::nullopt;
}

/// The user's files: the texts of a behavior and those of the plant.
void add_own_files(const Frame& frame, std::string_view name, const View& plant, EmitResult& result) {
  for (const View& behaviour : plant.lists.at("behaviours")) {
    View view{plant.texts, behaviour.lists};
    view.texts.insert(behaviour.texts.begin(), behaviour.texts.end());
    auto content = filled(name, frame, view, result);
    if (!content) return;  // all of them have the same fault
    result.own_files.push_back({view.texts["behaviour"], view.texts["behaviour_file"], base::text_of(*content)});
  }
}

/// The further files for which the user has templates, sorted; an error for every file that is not a template.
std::vector<std::string> further_files(const EmitOptions& options, EmitResult& result) {
  std::vector<std::string> names;
  if (options.templates_folder.empty()) return names;
  std::error_code unreadable;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(options.templates_folder, unreadable)) {
    const std::string file = entry.path().filename().generic_string();
    const std::string path = entry.path().generic_string();
    const bool named = file.ends_with(".mustache");
    if (file.front() == '.' && !named) continue;  // hidden: of an editor or a version control
    if (!named || !entry.is_regular_file(ignored)) {
      const std::string advice = named ? "give a file" : fmt::format("name it `{}.mustache`, or move it", file);
      result.errors.push_back(fmt::format("{}: not a template, so it would not be used: {}", path, advice));
      continue;
    }
    if (file.front() == '.' || file.find_first_of("\\:*?\"<>|\n\r\t") != file.npos) {
      result.errors.push_back(fmt::format("{}: the name of its file is not possible on every system: rename it", path));
      continue;
    }
    const std::string name = entry.path().stem().generic_string();
    const auto own = embedded_templates();
    if (std::none_of(own.begin(), own.end(), [&](const Template& known) { return known.name == name; })) {
      names.push_back(name);
    }
  }
  if (unreadable) {
    result.errors.push_back(
        fmt::format("{}: the folder cannot be read: {}", options.templates_folder, unreadable.message()));
  }
  std::sort(names.begin(), names.end());  // folders are listed in any order
  std::sort(result.errors.begin(), result.errors.end());
  return names;
}

}  // namespace

EmitResult emit(const model::PlantModel& plant, const lower::EngineTables& tables, const EmitOptions& options,
                const base::FileSystem& files) {
  EmitResult result;
  const View view = plant_view(plant, tables);
  const auto embedded = embedded_templates();
  std::vector<Template> templates(embedded.begin(), embedded.end());
  const std::vector<std::string> further = further_files(options, result);
  templates.reserve(templates.size() + further.size());
  for (const std::string& name : further) templates.push_back({name, ""});
  for (const Template& own : templates) {
    const auto frame = frame_of(own, options, files, result);
    if (!frame) continue;
    if (own.name == kOwnFile) {
      add_own_files(*frame, own.name, view, result);
    } else if (auto content = filled(own.name, *frame, view, result)) {
      result.files.push_back({std::string(own.name), std::move(*content)});
    }
  }
  return result;
}

}  // namespace symplant::emit

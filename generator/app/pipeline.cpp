// The pipeline of the tool.
#include "app/pipeline.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/io_findings.hpp"
#include "app/naming_findings.hpp"
#include "app/read_inputs.hpp"
#include "check/catalogue.hpp"
#include "description/description_rules.hpp"
#include "elements/malfunction/file.hpp"
#include "findings/finish.hpp"
#include "lower/limits.hpp"
#include "lower/lower.hpp"
#include "map/findings.hpp"
#include "map/url_findings.hpp"
#include "model/derive.hpp"
#include "name/named_table.hpp"
#include "symplant/json/location.hpp"

namespace symplant::app {
namespace {

/// "/devices/L_P_D" for a pointer into a device's entry; empty for other pointers.
std::string_view device_of(std::string_view pointer) {
  constexpr std::string_view kDevices = "/devices/";
  return pointer.starts_with(kDevices) ? pointer.substr(0, pointer.find('/', kDevices.size())) : std::string_view();
}

/// Adds the faults and warnings of the description at their locations. If the form of a device's entry has a fault, its
/// consequences are not reported.
void add_description_findings(const Inputs& inputs, const model::Evidence& evidence, diag::Diagnostics& diagnostics) {
  std::set<std::string_view> faulty;
  for (const description::DescriptionFault& fault : inputs.faults) faulty.insert(device_of(fault.pointer));
  std::vector<description::DescriptionFault> all = inputs.faults;
  for (const auto* list : {&evidence.faults, &evidence.warnings}) {
    std::copy_if(list->begin(), list->end(), std::back_inserter(all), [&](const description::DescriptionFault& fault) {
      const std::string_view device = device_of(fault.pointer);
      return device.empty() || faulty.count(device) == 0;
    });
  }
  std::vector<description::DescriptionFault> of_file;
  std::erase_if(all, [&](description::DescriptionFault& fault) {
    std::string pointer = inputs.malfunctions == nullptr
                              ? std::string()
                              : description::pointer_in_file(fault.pointer, inputs.own_malfunctions);
    if (pointer.empty()) return false;
    fault.pointer = std::move(pointer);
    of_file.push_back(std::move(fault));
    return true;
  });
  if (inputs.source != nullptr) description::add_findings(*inputs.source, all, diagnostics);
  if (inputs.malfunctions != nullptr) description::add_findings(inputs.malfunctions, of_file, diagnostics);
}

/// Finds the locations that rules gave as JSON pointers, in one pass over each text.
void locate(const std::shared_ptr<const description::PlantSource>& source, diag::Diagnostics& diagnostics) {
  const std::vector<std::string> pointers = diagnostics.pointers();
  if (source == nullptr || pointers.empty()) return;
  std::vector<json::Fault> wanted;
  wanted.reserve(pointers.size());
  for (const std::string& pointer : pointers)
    wanted.push_back({pointer, {}, 0, pointer.starts_with("/check/severity/")});
  std::vector<diag::Location> locations;
  locations.reserve(pointers.size());
  for (const auto& place : source->places(wanted)) locations.push_back(source->location(place));
  diagnostics.locate(locations);
}

/// Adds all findings about the plant. A description that does not fit its schema is not checked further.
void check(const Inputs& inputs, const model::Derived& derived, const lower::EngineTables& tables,
           diag::Diagnostics& diagnostics) {
  const model::PlantModel& plant = derived.plant;
  add_io_findings(inputs.io, inputs.source, diagnostics);
  add_description_findings(inputs, derived.evidence, diagnostics);
  if (inputs.source != nullptr) map::add_url_findings(plant, diagnostics);
  if (inputs.naming_parts != nullptr) add_naming_findings(plant, *inputs.naming_parts, diagnostics);
  if (!inputs.readable) return;
  check::check_plant(plant, derived.evidence, diagnostics);
  lower::check_limits(tables, diagnostics);
  if (!check::has_stopping_errors(diagnostics) && map::map_can_have_findings(plant))
    map::add_map_findings(plant, tables, diagnostics);
}

/// Prepares the findings for the user: folding, settings, selection, locations, order.
void finish(const Inputs& inputs, const model::PlantModel& plant, const CompileOptions& options,
            diag::Diagnostics& diagnostics) {
  const description::GivenCheck settings = inputs.readable ? plant.description->check : description::GivenCheck();
  diagnostics = findings::finish(std::move(diagnostics), settings, options.today, options.selection, options.known);
  if (inputs.readable) locate(inputs.source, diagnostics);
  diagnostics.sort_by_location(plant.sources());
}

}  // namespace

std::vector<model::ListInput> parse_names(const std::vector<ReadList>& lists, name::SymbolReader& reader,
                                          name::IoRows& io) {
  std::vector<model::ListInput> named;
  named.reserve(lists.size());
  for (const ReadList& list : lists) {
    named.push_back(
        {list.table, name::read_names(*list.table, reader, list.prefix, &io), list.controller, list.xy, list.prefix});
    if (list.prefix.empty()) continue;
    for (read::ListRow& row : list.table->rows)
      row.name = list.table->arena.emplace_back(list.prefix + std::string(row.name));
  }
  return named;
}

std::optional<Compiled> compile(const CompileOptions& options, const base::FileSystem& files, Progress& progress,
                                diag::Diagnostics& diagnostics) {
  std::optional<Inputs> inputs = read_inputs(options, files, progress, diagnostics);
  if (!inputs) {
    diagnostics = findings::sift(diagnostics, {}, {}, options.selection);
    diagnostics.sort_by_location();
    return std::nullopt;
  }
  progress.stage("parsing names");
  const auto reader = std::make_shared<name::SymbolReader>(inputs->naming);
  std::vector<model::ListInput> lists = parse_names(inputs->lists, *reader, inputs->io);
  progress.stage("deriving models");
  model::Derived named = model::derive(std::exchange(lists, {}), inputs->name, reader, inputs->description.get());
  model::Derived derived =
      model::describe(std::move(named), inputs->description, inputs->source,
                      inputs->naming_parts == nullptr ? std::vector<std::string>() : inputs->naming_parts->files);
  const bool sound = inputs->readable && derived.evidence.faults.empty();
  const bool lowered = sound && (options.tables || map::map_can_have_findings(derived.plant));
  progress.stage("lowering");
  lower::EngineTables tables = lowered ? lower::lower(derived.plant) : lower::EngineTables();
  progress.stage("checking");
  check(*inputs, derived, tables, diagnostics);
  finish(*inputs, derived.plant, options, diagnostics);
  if (!inputs->readable) return std::nullopt;
  return Compiled{std::move(derived.plant), std::move(derived.evidence), std::move(tables), inputs->own_malfunctions};
}

}  // namespace symplant::app

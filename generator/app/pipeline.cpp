// The whole road of the tool.
#include "app/pipeline.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/map_findings.hpp"
#include "app/read_inputs.hpp"
#include "app/url_findings.hpp"
#include "check/check_plant.hpp"
#include "description/description_rules.hpp"
#include "findings/causes.hpp"
#include "findings/settings.hpp"
#include "lower/limits.hpp"
#include "lower/lower.hpp"
#include "model/build_plant.hpp"
#include "symplant/json/location.hpp"

namespace symplant::app {
namespace {

/// "/devices/L_P_D" of what stands in a device's entry; empty of what does not.
std::string_view device_of(std::string_view pointer) {
  constexpr std::string_view kDevices = "/devices/";
  return pointer.starts_with(kDevices) ? pointer.substr(0, pointer.find('/', kDevices.size())) : std::string_view();
}

/// Faults and warnings of the description at their places. Where an entry's form is at fault already, what follows from
/// that is not told.
void add_description_findings(const Inputs& inputs, const model::PlantModel& plant, diag::Diagnostics& diagnostics) {
  std::set<std::string_view> faulty;
  for (const description::DescriptionFault& fault : inputs.faults) faulty.insert(device_of(fault.pointer));
  std::vector<description::DescriptionFault> all = inputs.faults;
  for (const auto* list : {&plant.description_faults, &plant.description_warnings}) {
    std::copy_if(list->begin(), list->end(), std::back_inserter(all), [&](const description::DescriptionFault& fault) {
      const std::string_view device = device_of(fault.pointer);
      return device.empty() || faulty.count(device) == 0;
    });
  }
  description::add_findings(inputs.source, all, diagnostics);
}

/// Finds the places that rules told as JSON pointers. One pass over the text for all of them.
void locate(const std::shared_ptr<const text::SourceFile>& source, diag::Diagnostics& diagnostics) {
  const std::vector<std::string> pointers = diagnostics.pointers();
  if (source == nullptr || pointers.empty()) return;
  std::vector<json::Fault> wanted;
  wanted.reserve(pointers.size());
  for (const std::string& pointer : pointers)
    wanted.push_back({pointer, {}, 0, pointer.starts_with("/check/severity/")});
  std::vector<std::optional<text::Span>> spans;
  spans.reserve(pointers.size());
  for (const json::Span& span : json::spans(source->text(), wanted)) spans.push_back(text::Span{span.begin, span.end});
  diagnostics.locate(source, spans);
}

}  // namespace

std::optional<model::PlantModel> analyse(const CompileOptions& options, const base::FileSystem& files,
                                         Progress& progress, diag::Diagnostics& diagnostics) {
  const auto inputs = read_inputs(options, files, progress, diagnostics);
  if (!inputs) {
    diagnostics = findings::select(std::move(diagnostics), options.selection);
    return std::nullopt;
  }

  progress.stage("deriving models");
  model::PlantModel plant = model::build_plant(inputs->lists, {inputs->name, inputs->description});
  plant.description_source = inputs->source;
  if (inputs->source != nullptr) {
    add_description_findings(*inputs, plant, diagnostics);
    add_url_findings(plant, diagnostics);
  }

  if (inputs->readable) {
    progress.stage("checking");
    check::check_plant(plant, diagnostics);
    if (!diagnostics.has_errors() && symbols_can_overlap(plant)) add_map_findings(plant, diagnostics);
    if (const description::GivenCheck& settings = plant.description->check;
        !settings.severity.empty() || !settings.ignore.empty()) {
      diagnostics = findings::apply_settings(diagnostics, settings, options.today);
    }
  }
  diagnostics = findings::select(std::move(diagnostics), options.selection);
  if (inputs->readable) {
    findings::fold_consequences(plant, diagnostics);
    locate(inputs->source, diagnostics);
  }
  diagnostics.sort_by_location(plant.sources());
  if (!inputs->readable) return std::nullopt;
  return plant;
}

std::optional<Compiled> compile(const CompileOptions& options, const base::FileSystem& files, Progress& progress,
                                diag::Diagnostics& diagnostics) {
  auto plant = analyse(options, files, progress, diagnostics);
  if (!plant || diagnostics.has_errors()) return std::nullopt;
  progress.stage("lowering");
  lower::EngineTables tables = lower::lower(*plant);
  lower::check_limits(tables, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return Compiled{std::move(*plant), std::move(tables)};
}

}  // namespace symplant::app

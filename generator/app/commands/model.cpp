// symplant model: the derived models.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/tables/nearest.hpp"
#include "text/pattern.hpp"
#include "view/formats.hpp"

namespace symplant::app {
namespace {

struct ModelOptions {
  std::string plant;
  PlantOptions plant_options;
  std::string format = "table";
  std::string device = "*";
  std::string output;
};

/// A message for a pattern without a match. A name without `*` and `?` gets the nearest existing name.
void report_no_match(const std::string& pattern, const model::PlantModel& plant, std::ostream& err) {
  std::string_view nearest;
  std::vector<std::string> names;
  if (!text::is_pattern(pattern)) {
    for (const model::Unit& unit : plant.units) names.emplace_back(unit.path);
    for (std::uint32_t l = 0; l < plant.material.locations(); ++l) names.emplace_back(plant.material.location_name(l));
    tables::NearestName found(pattern);
    for (const std::string& name : names) found.offer(name);
    nearest = found.name();
  }
  err << "error: no device, track or place matches `" << pattern << "`"
      << (nearest.empty() ? ": `*` matches any text, `?` one character"
                          : "; did you mean `" + std::string(nearest) + "`?")
      << "\n";
}

void show(const ModelOptions& options, Context& context) {
  auto made = compile_for(context, options.plant, options.plant_options);
  if (!made) return;
  const auto compiled = std::make_shared<const Compiled>(std::move(*made));
  context.kept = compiled;
  std::vector<std::uint32_t> units;
  for (std::uint32_t u = 0; u < compiled->plant.units.size(); ++u) {
    if (text::matches_pattern(compiled->plant.units[u].path, options.device)) units.push_back(u);
  }
  const model::Material& material = compiled->plant.material;
  std::vector<std::uint32_t> locations;
  for (std::uint32_t l = 0; l < material.locations(); ++l) {
    if (text::matches_pattern(material.location_name(l), options.device)) locations.push_back(l);
  }
  if (units.empty() && locations.empty() && options.device != "*") {
    report_no_match(options.device, compiled->plant, context.err);
    context.exit_code = host::kBadInput;
    return;
  }
  const view::View view =
      view::find_format(options.format)
          ->render({compiled->plant, compiled->tables, std::move(units), std::move(locations), context.programs});
  if (options.plant_options.verbose) {
    for (const std::string& decision : view.decisions) context.err << "decided: " << decision << "\n";
  }
  write_result(context, options.output, view.text, compiled->plant.input_files());
}

}  // namespace

void add_model(CLI::App& app, Context& context) {
  auto options = std::make_shared<ModelOptions>();
  CLI::App* command =
      app.add_subcommand("model", "Show the derived models: I, O, S and the five functions of each device");
  command->add_option("PLANT", options->plant, "a plant.json or a symbol list")->required();
  std::vector<std::string> names;
  std::string help;
  for (const view::Format& format : view::formats()) {
    names.emplace_back(format.name);
    help.append(help.empty() ? "" : "; ").append(format.name).append(": ").append(format.what);
  }
  command->add_option("--format", options->format, help)->check(CLI::IsMember(names));
  command->add_option("--device", options->device, "only the devices, tracks and places that match; * and ? allowed")
      ->type_name("PATTERN");
  command->add_option("-o,--output", options->output, "write the result to this file")->type_name("FILE");
  add_plant_options(*command, options->plant_options);
  command->footer(
      "Examples:\n  symplant model symbols.csv\n  symplant model symbols.csv --device 'EXLINE_*' --format json");
  command->callback([options, &context] { show(*options, context); });
}

}  // namespace symplant::app

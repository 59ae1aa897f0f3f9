// symplant map: shows the I/O map.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <ostream>
#include <utility>
#include <variant>
#include <vector>

#include "app/commands.hpp"
#include "app/map/formats.hpp"
#include "app/map_findings.hpp"
#include "app/options.hpp"
#include "app/stream_sink.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/link/choice.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::app {
namespace {

using Choices = std::vector<link::LinkChoice>;

/// The links whose maps to show: those of the command line, else one for each controller, as in plant.json.
std::variant<Choices, link::LinkError> wanted(const model::PlantModel& plant, const tables::PlantTables& tables,
                                              const std::vector<std::string>& links) {
  if (links.empty()) {
    Choices choices;
    const std::size_t controllers = std::max<std::size_t>(1, tables::split_names(tables.controller_names).size());
    for (std::uint32_t controller = 0; controller < controllers; ++controller) {
      const description::LinkDescription* const own = link_of(plant, controller);
      choices.push_back({own == nullptr ? "" : own->url, controller});
    }
    return choices;
  }
  std::vector<link::LinkRequest> requests;
  requests.reserve(links.size());
  for (const std::string& text : links) requests.push_back(link::parse_request(text));
  for (const link::LinkRequest& request : requests) {
    const auto usage = [](std::string message) {
      return link::LinkError{link::LinkError::Kind::usage, std::move(message)};
    };
    if (link::is_loop(request.url)) return usage("`loop:` carries symbols by name, it has no map of addresses");
    if (std::string fault = link::url_fault(request.url); !fault.empty()) return usage(std::move(fault));
  }
  return link::choose_links(tables, requests);
}

struct MapOptions {
  std::string plant;
  PlantOptions plant_options;
  std::vector<std::string> links;
  std::string format = "table";
};

void show(const MapOptions& options, Context& context) {
  auto made = compile_for(context, options.plant, options.plant_options);
  if (!made) return;
  const auto compiled = std::make_shared<const Compiled>(std::move(*made));
  context.kept = compiled;
  const model::PlantModel& plant = compiled->plant;
  const tables::PlantTables tables = compiled->tables.tables();
  const auto fail = [&](const link::LinkError& error) {
    context.err << "error: " << error.message << "\n";
    context.exit_code = host::kBadInput;
  };
  const auto choices = wanted(plant, tables, options.links);
  if (const auto* error = std::get_if<link::LinkError>(&choices)) return fail(*error);
  const auto of = std::make_shared<const LinkedPlant>(plant, tables);
  std::vector<LinkView> views;
  for (const link::LinkChoice& choice : std::get<Choices>(choices)) {
    auto view = view_of(of, choice);
    if (const auto* error = std::get_if<link::LinkError>(&view)) return fail(*error);
    views.push_back(std::get<LinkView>(std::move(view)));
  }
  const auto formats = map_formats();
  const auto format =
      std::find_if(formats.begin(), formats.end(), [&](const MapFormat& one) { return one.name == options.format; });
  StreamSink out(context.out);
  if (const auto error = write_maps(*format, views, out)) fail(*error);
}

}  // namespace

void add_map(CLI::App& app, Context& context) {
  auto options = std::make_shared<MapOptions>();
  CLI::App* command =
      app.add_subcommand("map", "Show the address of each I/O symbol on a link, and what drives it or what it drives");
  command->add_option("PLANT", options->plant, "a plant.json or a symbol list")->required();
  command->add_option("--link", options->links,
                      "[CONTROLLER=]URL: the map of this link only; of a link that goes to a PLC the devices there");
  std::vector<std::string> names;
  std::string help;
  for (const MapFormat& format : map_formats()) {
    names.emplace_back(format.name);
    help.append(help.empty() ? "" : "; ").append(format.name).append(": ").append(format.what);
  }
  command->add_option("--format", options->format, help)->check(CLI::IsMember(names));
  add_plant_options(*command, options->plant_options);
  command->footer(
      "Modbus numbers count from 0, Modicon numbers from 1.\nExamples:\n  symplant map symbols.csv\n"
      "  symplant map plant.json --link PLC1=modbus-tcp-server://127.0.0.1:1502\n"
      "  symplant map plant.json --format openplc > mbconfig.cfg\n"
      "  symplant map symbols.csv --link \"modbus-tcp://192.168.0.10:502?events=coils:800\"\n"
      "  symplant map symbols.csv --link \"slmp://192.168.3.39:5000?family=q&map=X0-X7F:M1000\"");
  command->callback([options, &context] { show(*options, context); });
}

}  // namespace symplant::app

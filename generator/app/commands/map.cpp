// symplant map: shows the I/O map.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <ostream>
#include <utility>

#include "app/commands.hpp"
#include "app/map_notes.hpp"
#include "app/map_table.hpp"
#include "app/options.hpp"
#include "app/stream_sink.hpp"
#include "diag/visible_text.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/link/choice.hpp"
#include "symplant/link/io_map.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::app {
namespace {

/// The controllers whose maps to show: all, or those that the links name. Nothing, and an error, if a link has no map.
std::optional<std::vector<std::uint32_t>> wanted(const tables::PlantTables& tables,
                                                 const std::vector<std::string>& links, Context& context) {
  std::vector<std::uint32_t> controllers;
  std::vector<link::LinkRequest> requests;
  requests.reserve(links.size());
  for (const std::string& text : links) requests.push_back(link::parse_request(text));
  const auto fail = [&](const std::string& message) {
    context.err << "error: " << message << "\n";
    context.exit_code = host::kBadInput;
    return std::nullopt;
  };
  for (const link::LinkRequest& request : requests) {
    if (link::is_loop(request.url)) return fail("`loop:` carries symbols by name, it has no map of addresses");
    if (!request.url.starts_with("modbus-tcp-server:")) {
      return fail("`" + request.url + "` is not a link with a map: give `modbus-tcp-server://HOST:PORT`");
    }
  }
  const auto chosen = link::choose_links(tables, requests);
  if (const auto* error = std::get_if<link::LinkError>(&chosen)) return fail(error->message);
  for (const link::LinkChoice& choice : std::get<std::vector<link::LinkChoice>>(chosen)) {
    controllers.push_back(choice.controller);
  }
  if (links.empty()) {
    controllers.resize(std::max<std::size_t>(1, tables::split_names(tables.controller_names).size()));
    std::iota(controllers.begin(), controllers.end(), 0U);
  }
  return controllers;
}

struct MapOptions {
  std::string plant;
  PlantOptions plant_options;
  std::vector<std::string> links;
};

void show(const MapOptions& options, Context& context) {
  auto made = compile_for(context, options.plant, options.plant_options);
  if (!made) return;
  const auto compiled = std::make_shared<const Compiled>(std::move(*made));
  context.kept = compiled;
  const model::PlantModel& plant = compiled->plant;
  const tables::PlantTables tables = compiled->tables.tables();
  const auto controllers = wanted(tables, options.links, context);
  if (!controllers) return;
  for (const std::uint32_t controller : *controllers) {
    if (plant.controllers.size() > 1) {
      const std::string& called = plant.controllers[controller];
      context.out << (controller == controllers->front() ? "" : "\n")
                  << (called.empty() ? "the controller without a name" : "controller " + diag::visible(called)) << "\n";
    }
    const link::LinkSettings settings = plant.links[controller].settings();
    const link::IoMap map = link::make_io_map(tables, controller, settings);
    StreamSink out(context.out);
    write_map_table(plant, tables, controller, map, out);
    context.out << map_notes(tables, map, settings);
  }
}

}  // namespace

void add_map(CLI::App& app, Context& context) {
  auto options = std::make_shared<MapOptions>();
  CLI::App* command = app.add_subcommand("map", "Show the address of each I/O symbol on a link, and what drives it");
  command->add_option("PLANT", options->plant, "a plant.json or a symbol list")->required();
  command->add_option("--link", options->links, "[CONTROLLER=]URL: only the map of this link's controller");
  add_plant_options(*command, options->plant_options);
  command->footer(
      "Modbus numbers count from 0, Modicon numbers from 1.\nExamples:\n  symplant map symbols.csv\n"
      "  symplant map plant.json --link PLC1=modbus-tcp-server://127.0.0.1:1502");
  command->callback([options, &context] { show(*options, context); });
}

}  // namespace symplant::app

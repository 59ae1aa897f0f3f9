// symplant map: shows the I/O map.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <memory>
#include <ostream>
#include <utility>
#include <variant>
#include <vector>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "app/stream_sink.hpp"
#include "map/formats.hpp"
#include "map/link_view.hpp"
#include "symplant/host/exit_codes.hpp"

namespace symplant::app {
namespace {

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
  const tables::PlantTables tables = compiled->tables.tables();
  const auto fail = [&](const link::LinkError& error) {
    context.err << "error: " << error.message << "\n";
    context.exit_code = host::kBadInput;
  };
  const auto views = map::views_of(std::make_shared<const map::LinkedPlant>(compiled->plant, tables), options.links);
  if (const auto* error = std::get_if<link::LinkError>(&views)) return fail(*error);
  const auto formats = map::map_formats();
  const auto format = std::find_if(formats.begin(), formats.end(),
                                   [&](const map::MapFormat& one) { return one.name == options.format; });
  StreamSink out(context.out);
  if (const auto error = write_maps(*format, std::get<std::vector<map::LinkView>>(views), out)) fail(*error);
}

}  // namespace

void add_map(CLI::App& app, Context& context) {
  auto options = std::make_shared<MapOptions>();
  CLI::App* command =
      app.add_subcommand("map", "Show the address of each I/O symbol on a link, and what drives it or what it drives");
  command->add_option("PLANT", options->plant, "a plant.json or a symbol list")->required();
  command->add_option(
      "--link", options->links,
      "[CONTROLLER=]URL: show only this link; for a link that goes to a PLC, show the addresses in the PLC");
  std::vector<std::string> names;
  std::string help;
  for (const map::MapFormat& format : map::map_formats()) {
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

// symplant map: shows the I/O map.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <optional>
#include <ostream>

#include "app/commands.hpp"
#include "app/map_notes.hpp"
#include "app/options.hpp"
#include "diag/visible_text.hpp"
#include "symplant/host/exit_codes.hpp"
#include "symplant/link/choice.hpp"
#include "symplant/link/io_map.hpp"
#include "symplant/tables/names.hpp"
#include "text/utf8.hpp"

namespace symplant::app {
namespace {

constexpr std::size_t kColumns = 9;
constexpr std::size_t kWords = 6;   ///< the column of word orders, shown if a number takes several registers
constexpr std::size_t kOnLoss = 7;  ///< shown if symbols differ in it

struct Row {
  std::array<std::string, kColumns> cells;
};

/// The width of a text in columns of a terminal.
std::size_t width_of(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const text::CodePoint point = text::code_point_at(text, at);
    width += static_cast<std::size_t>(diag::display_width(point.value));
    at += point.length;
  }
  return width;
}

std::string table_text(const std::vector<Row>& rows, const std::array<bool, kColumns>& shown) {
  std::array<std::size_t, kColumns> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < kColumns; ++i) widths[i] = std::max(widths[i], width_of(row.cells[i]));
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < kColumns; ++i) {
      if (!shown[i]) continue;
      line += row.cells[i];
      line.append(widths[i] - width_of(row.cells[i]) + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

/// What drives a symbol; `-` for an event that no device drives.
std::string driver(const model::PlantModel& plant, const tables::PlantTables& tables, std::uint32_t index) {
  const model::Symbol& symbol = plant.symbols[index];
  const auto unit_of = [&](const model::Symbol& of) { return std::string(plant.units[of.unit].path); };
  const bool moved = tables.symbols[index].moved();
  if (symbol.direction == tables::Direction::operation) {
    return moved ? "the PLC, moves " + unit_of(symbol) : "the PLC, moves nothing";
  }
  if (moved) return unit_of(symbol);
  if (symbol.leader != model::kNone && tables.symbols[symbol.leader].moved()) {
    return unit_of(plant.symbols[symbol.leader]);
  }
  return "-";
}

bool is_operation(const link::IoPoint& point) {
  return point.table == link::Table::coil || point.table == link::Table::holding_register;
}

/// Which columns are not empty in this map.
std::array<bool, kColumns> columns_of(const link::IoMap& map, const link::LinkSettings& settings) {
  std::array<bool, kColumns> shown{};
  shown.fill(true);
  const auto any = [&](auto has) { return std::any_of(map.points.begin(), map.points.end(), has); };
  shown[kWords] = any([](const link::IoPoint& point) { return point.width > 1; });
  shown[kOnLoss] =
      any([&](const link::IoPoint& point) { return is_operation(point) && point.on_loss != settings.on_loss; });
  return shown;
}

/// The map of one controller: the symbols that a link to it carries.
std::string map_text(const model::PlantModel& plant, const tables::PlantTables& tables, std::uint32_t controller) {
  const link::LinkSettings settings = plant.links[controller].settings();
  const link::IoMap map = link::make_io_map(tables, controller, settings);
  std::vector<const link::IoPoint*> points(tables.symbols.size());
  for (const link::IoPoint& point : map.points) points[point.symbol] = &point;

  std::vector<Row> rows{{{"row", "symbol", "address", "IEC", "Modbus", "Modicon", "words", "on loss", "driven by"}}};
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
    const model::Symbol& symbol = plant.symbols[i];
    if (plant.controller_of(symbol) != controller) continue;
    const link::IoPoint* point = points[i];
    const std::string list = plant.lists.size() == 1 ? "" : diag::visible(plant.list_of(symbol).name()) + ":";
    const bool wide = point != nullptr && point->width > 1;
    const bool operation = point != nullptr && is_operation(*point);
    rows.push_back({{list + std::to_string(symbol.row->line), diag::visible(symbol.name()),
                     diag::visible(symbol.row->vendor_address), diag::visible(symbol.row->iec_address),
                     point == nullptr ? "-" : address_text(*point), point == nullptr ? "-" : modicon_text(*point),
                     wide ? word_order_text(point->word_order) : "",
                     !operation                             ? ""
                     : point->on_loss == link::OnLoss::hold ? "holds"
                                                            : "off",
                     driver(plant, tables, i)}});
  }
  return table_text(rows, columns_of(map, settings)) + map_notes(tables, map, settings);
}

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
  const auto compiled = compile_for(context, options.plant, options.plant_options);
  if (!compiled) return;
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
    context.out << map_text(plant, tables, controller);
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

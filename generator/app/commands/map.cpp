// symplant map: the I/O map.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <ostream>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "base/utf8.hpp"
#include "diag/visible_text.hpp"
#include "symplant/link/io_map.hpp"

namespace symplant::app {
namespace {

struct Row {
  std::array<std::string, 7> cells;
};

/// Columns on a terminal.
std::size_t width_of(std::string_view text) {
  std::size_t width = 0;
  for (std::size_t at = 0; at < text.size();) {
    const base::CodePoint point = base::code_point_at(text, at);
    width += static_cast<std::size_t>(diag::display_width(point.value));
    at += point.length;
  }
  return width;
}

std::string table_text(const std::vector<Row>& rows) {
  std::array<std::size_t, 7> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], width_of(row.cells[i]));
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      line += row.cells[i];
      line.append(widths[i] - width_of(row.cells[i]) + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

/// "coil 1", "holding registers 10-11".
std::string place_text(const link::IoPoint& point) {
  const std::string name = link::table_name(point.table);
  if (point.places == 1) return fmt::format("{} {}", name, point.number);
  return fmt::format("{}s {}-{}", name, point.number, point.last());
}

std::string modicon_text(const link::IoPoint& point) {
  const std::string first = fmt::format("{:05}", link::modicon_number(point.table, point.number));
  if (point.places == 1) return first;
  const auto last = static_cast<std::uint16_t>(point.last());
  return fmt::format("{}-{:05}", first, link::modicon_number(point.table, last));
}

std::string notes(const link::IoMap& map) {
  std::string text;
  for (std::size_t t = 0; t < link::kTables; ++t) {
    if (map.sizes[t] == 0) continue;
    fmt::format_to(std::back_inserter(text), "{}s: {} places{}\n", link::table_name(static_cast<link::Table>(t)),
                   map.sizes[t],
                   map.packed[t] ? ", packed in list order, since an address has no number below 65536" : "");
  }
  const auto count = [&](const std::vector<std::uint32_t>& symbols, std::string_view why) {
    if (!symbols.empty()) fmt::format_to(std::back_inserter(text), "on no link: {} {}\n", symbols.size(), why);
  };
  count(map.without_address, "without a usable address");
  count(map.of_8_bits, "of 8 bits, whose place nobody gives");
  count(map.too_many, "beyond the 65536 places of a table");
  return text;
}

/// Who moves a symbol.
std::string mover(const model::PlantModel& plant, const core::PlantTables& tables, std::uint32_t index) {
  const model::Symbol& symbol = plant.symbols[index];
  const auto unit_of = [&](const model::Symbol& of) { return std::string(plant.units[of.unit].path); };
  const bool moved = tables.symbols[index].moved();
  if (symbol.direction == core::Direction::operation) {
    return moved ? "the PLC, moves " + unit_of(symbol) : "the PLC, moves nothing";
  }
  if (moved) return unit_of(symbol);
  if (symbol.leader != model::kNone && tables.symbols[symbol.leader].moved()) {
    return unit_of(plant.symbols[symbol.leader]);
  }
  return "nobody";
}

/// The map of one controller: what a link to it carries.
std::string map_text(const model::PlantModel& plant, const core::PlantTables& tables, std::uint32_t controller) {
  const link::IoMap map = link::make_io_map(tables, controller, {});
  std::vector<const link::IoPoint*> points(tables.symbols.size());
  for (const link::IoPoint& point : map.points) points[point.symbol] = &point;

  std::vector<Row> rows{{{"row", "symbol", "address", "IEC", "Modbus", "Modicon", "moved by"}}};
  for (std::uint32_t i = 0; i < tables.symbols.size(); ++i) {
    const model::Symbol& symbol = plant.symbols[i];
    if (plant.controller_of(symbol) != controller) continue;
    const link::IoPoint* point = points[i];
    const std::string list = plant.lists.size() == 1 ? "" : diag::visible(plant.list_of(symbol).name()) + ":";
    rows.push_back({{list + std::to_string(symbol.row->line), diag::visible(symbol.name()),
                     diag::visible(symbol.row->vendor_address), diag::visible(symbol.row->iec_address),
                     point == nullptr ? "-" : place_text(*point), point == nullptr ? "-" : modicon_text(*point),
                     mover(plant, tables, i)}});
  }
  return table_text(rows) + notes(map);
}

void show(const std::string& name, const PlantOptions& options, Context& context) {
  const auto compiled = compile_for(context, name, options);
  if (!compiled) return;
  const model::PlantModel& plant = compiled->plant;
  const core::PlantTables tables = compiled->tables.tables();
  for (std::uint32_t controller = 0; controller < plant.controllers.size(); ++controller) {
    if (plant.controllers.size() > 1) {
      const std::string& called = plant.controllers[controller];
      context.out << (controller == 0 ? "" : "\n")
                  << (called.empty() ? "the controller without a name" : "controller " + diag::visible(called)) << "\n";
    }
    context.out << map_text(plant, tables, controller);
  }
}

}  // namespace

void add_map(CLI::App& app, Context& context) {
  struct Options {
    std::string plant;
    PlantOptions plant_options;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("map", "Show where each I/O symbol stands on a link, and who moves it");
  command->add_option("PLANT", options->plant, "a plant.json or a symbol list")->required();
  add_plant_options(*command, options->plant_options);
  command->footer("Modbus numbers count from 0, Modicon numbers from 1.\nExamples:\n  symplant map symbols.csv");
  command->callback([options, &context] { show(options->plant, options->plant_options, context); });
}

}  // namespace symplant::app

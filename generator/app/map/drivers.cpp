// What drives each symbol of a map, in words.
#include "app/map/drivers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diag/visible_text.hpp"
#include "symplant/tables/names.hpp"

namespace symplant::app {
namespace {

using Driver = why::SymbolDriver::Kind;

bool is_event(const LinkView& view, std::uint32_t symbol) {
  return view.of->plant.symbols[symbol].direction == tables::Direction::event;
}

std::string unit_name(const LinkView& view, std::uint32_t unit) { return std::string(view.of->plant.units[unit].path); }

std::string reader_name(const LinkView& view, const why::SymbolReader& reader) {
  switch (reader.kind) {
    case why::SymbolReader::Kind::requirement:
      return "requirement " + view.of->plant.requirements[reader.index].name;
    case why::SymbolReader::Kind::event:
      return std::string(view.of->plant.symbols[reader.index].name());
    case why::SymbolReader::Kind::track:
      return view.of->plant.material.tracks[reader.index].name;
    case why::SymbolReader::Kind::transfer:
      return "transfer " + view.of->plant.material.transfers[reader.index].name;
    case why::SymbolReader::Kind::work:
      return "work " + view.of->plant.material.work[reader.index].name;
    case why::SymbolReader::Kind::source:
      return "source " + view.of->plant.material.sources[reader.index].name;
    case why::SymbolReader::Kind::malfunction:
      return "malfunction " + view.of->plant.malfunctions[reader.index].name;
    case why::SymbolReader::Kind::unit:
    case why::SymbolReader::Kind::behavior:
      break;
  }
  return unit_name(view, reader.index);
}

}  // namespace

std::optional<std::string> driven_by(const LinkView& view, std::uint32_t symbol) {
  if (!is_event(view, symbol)) return "the PLC";
  const why::SymbolDriver driver = view.of->use.driver(symbol);
  switch (driver.kind) {
    case Driver::none:
      break;
    case Driver::unit:
    case Driver::behavior:
      return unit_name(view, driver.unit);
    case Driver::condition:
      return "a condition";
    case Driver::part:
      return "parts at " + view.of->plant.material.location_name(driver.unit);
  }
  return std::nullopt;
}

std::optional<std::string> moved_device(const LinkView& view, std::uint32_t symbol) {
  const why::SymbolDriver driver = view.of->use.driver(symbol);
  if (is_event(view, symbol) || driver.kind != Driver::unit) return std::nullopt;
  return unit_name(view, driver.unit);
}

std::vector<std::string> readers_of(const LinkView& view, std::uint32_t symbol) {
  std::vector<std::string> names;
  if (is_event(view, symbol)) return names;
  const auto add = [&](std::string name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  };
  for (const why::SymbolReader& reader : view.of->use.readers(symbol)) add(reader_name(view, reader));
  const why::SymbolDriver driver = view.of->use.driver(symbol);
  if (driver.kind == Driver::behavior) add(unit_name(view, driver.unit));
  if (view.choice.settings.clock.symbol == symbol) add("plant time");
  return names;
}

std::string driver_text(const LinkView& view, std::uint32_t symbol) {
  if (is_event(view, symbol)) return driven_by(view, symbol).value_or("-");
  if (const auto moved = moved_device(view, symbol)) return "the PLC, moves " + *moved;
  const std::vector<std::string> readers = readers_of(view, symbol);
  if (readers.empty()) return "the PLC, moves nothing";
  const std::string more = readers.size() == 1 ? "" : fmt::format(" and {} more", readers.size() - 1);
  return "the PLC, read by " + diag::visible(readers.front()) + more;
}

}  // namespace symplant::app

// What drives each symbol of a map, in words.
#include "map/drivers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diag/visible_text.hpp"
#include "symplant/why/driven_things.hpp"

namespace symplant::map {
namespace {

using Driver = why::SymbolDriver::Kind;

bool is_event(const LinkView& view, std::uint32_t symbol) {
  return view.of->plant.symbols[symbol].direction == tables::Direction::event;
}

std::string unit_name(const LinkView& view, std::uint32_t unit) { return std::string(view.of->plant.units[unit].path); }

bool is_clock(const LinkView& view, std::uint32_t symbol) { return view.choice.settings.clock.symbol == symbol; }

/// "EXLINE_MB_AGV, track CV1", "A, B, C and 2 more".
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMostNamed = 3;
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kMostNamed; ++i) {
    text.append(i == 0 ? "" : ", ").append(diag::visible(names[i]));
  }
  return names.size() <= kMostNamed ? text : text + fmt::format(" and {} more", names.size() - kMostNamed);
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
    case Driver::condition: {
      const model::Symbol& leader = view.of->plant.symbols[view.of->use.leader(symbol)];
      return leader.account == model::Account::shows_value ? "a formula" : "a condition";
    }
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
  for (const why::SymbolReader& reader : view.of->use.readers(symbol)) add(why::reader_words(reader, view.of->names));
  const why::SymbolDriver driver = view.of->use.driver(symbol);
  if (driver.kind == Driver::behavior) add(unit_name(view, driver.unit));
  if (is_clock(view, symbol)) add("plant time");
  return names;
}

std::vector<std::string> driven_things(const LinkView& view, std::uint32_t symbol) {
  if (is_event(view, symbol)) return {};
  std::vector<std::string> things = why::driven_things(symbol, view.of->use, view.of->names);
  if (is_clock(view, symbol)) things.emplace_back("plant time");
  return things;
}

std::string driver_text(const LinkView& view, std::uint32_t symbol) { return driven_by(view, symbol).value_or("-"); }

std::string drives_text(const LinkView& view, std::uint32_t symbol) {
  if (is_event(view, symbol)) return "";
  const std::vector<std::string> things = driven_things(view, symbol);
  if (!things.empty()) return listed(things);
  const std::vector<std::string> readers = readers_of(view, symbol);
  return readers.empty() ? "-" : fmt::format("- (read by {})", listed(readers));
}

}  // namespace symplant::map

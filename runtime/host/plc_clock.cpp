// Plant time from a PLC's clock: which operation it is, and reporting its restarts.
#include "symplant/host/plc_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "symplant/link/clock_symbol.hpp"
#include "symplant/link/kinds.hpp"
#include "symplant/link/link_map.hpp"
#include "symplant/tables/ascii.hpp"
#include "symplant/tables/lists.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/tables/nearest.hpp"

namespace symplant::host {
namespace {

/// `1 ms`, `100 us`.
std::string unit_text(tables::Time unit) {
  constexpr std::array<std::pair<tables::Time, const char*>, 3> kUnits{
      {{tables::kSecond, "s"}, {tables::kMillisecond, "ms"}, {tables::kMicrosecond, "us"}}};
  for (const auto& [size, name] : kUnits) {
    if (unit % size == 0) return fmt::format("{} {}", unit / size, name);
  }
  return fmt::format("{} ns", unit);
}

/// The names of all symbols, each followed by its address.
using SymbolTexts = std::vector<std::string_view>;

std::string not_found(const SymbolTexts& texts, std::string_view wanted) {
  tables::NearestName nearest(wanted);
  for (std::size_t i = 0; i < texts.size(); i += 2) nearest.offer(texts[i]);
  return fmt::format("symbol `{}` not found; {}", wanted,
                     nearest.name().empty() ? "write the name of an operation that the PLC counts up"
                                            : fmt::format("did you mean `{}`?", nearest.name()));
}

/// The link to a PLC that carries the symbol's controller.
std::optional<std::size_t> link_of(std::uint32_t symbol, const LinkChoices& links, const tables::PlantTables& tables) {
  const std::uint32_t controller = tables::controller_of(tables, symbol);
  const auto found = std::find_if(links.begin(), links.end(), [&](const link::LinkChoice& choice) {
    return !link::is_loop(choice.url) && choice.controller == controller;
  });
  if (found == links.end()) return std::nullopt;
  return static_cast<std::size_t>(found - links.begin());
}

std::string no_link(std::string_view name, std::uint32_t symbol, const tables::PlantTables& tables) {
  const auto controllers = tables::split_names(tables.controller_names);
  const bool says_whose = controllers.size() > 1;
  const std::string_view controller = says_whose ? controllers[tables::controller_of(tables, symbol)] : "";
  return fmt::format("no link to a PLC carries `{}`: add one, `--link {}{}URL`", name, controller,
                     controller.empty() ? "" : "=");
}

/// Whether a link that needs a number for each symbol has none for this one; another one reports this itself.
bool has_no_number(std::uint32_t symbol, const link::LinkChoice& choice, const tables::PlantTables& tables) {
  const link::Kind* const kind = link::kind_of(choice.url);
  if (kind == nullptr || !kind->numbered) return false;
  const auto made = link::map_of(choice, tables);
  const auto* const map = std::get_if<link::LinkMap>(&made);
  return map != nullptr && std::any_of(map->left_out.begin(), map->left_out.end(),
                                       [&](const link::Unreachable& one) { return one.symbol == symbol; });
}

ChosenPlcClock failed(std::string error) { return {std::nullopt, std::move(error), ""}; }

/// The clock `symbol`; `unit`: as given on the command line.
ChosenPlcClock choose(std::uint32_t symbol, std::string_view name, std::optional<tables::Time> unit,
                      const LinkChoices& links, const tables::PlantTables& tables) {
  const tables::SymbolRow& row = tables.symbols[symbol];
  const std::string fault = link::clock_fault(row.type(), row.direction());
  if (!fault.empty()) return failed(fmt::format("`{}` {}", name, fault));
  const auto link = link_of(symbol, links, tables);
  if (!link) return failed(no_link(name, symbol, tables));
  if (has_no_number(symbol, links[*link], tables)) {
    return failed(
        fmt::format("`{}` has no address, so no link carries it: give it one, or a `number` in `links`", name));
  }
  const link::ClockSettings& settings = links[*link].settings.clock;
  const exec::PlcClockOptions clock{link::clock_bits(row.type()), unit.value_or(settings.unit), settings.limit};
  return {PlcClockChoice{std::string(name), symbol, *link, clock}, "", ""};
}

}  // namespace

std::string PlcClockChoice::text() const {
  return fmt::format("`{}` ({} bits, {})", name, clock.bits, unit_text(clock.unit));
}

ChosenPlcClock choose_plc_clock(const PlantProgram& program, const RunOptions& options, const LinkChoices& links) {
  const tables::PlantTables& tables = program.tables;
  if (options.clock == RunOptions::Clock::plc) {
    const SymbolTexts texts = tables::split_names(tables.symbol_names);
    for (std::uint32_t symbol = 0; symbol < tables.symbols.size(); ++symbol) {
      const std::string_view name = texts[2 * std::size_t{symbol}];
      if (tables::equal_ignoring_case(name, options.plc_clock)) {
        return choose(symbol, name, options.plc_unit, links, tables);
      }
    }
    return failed(not_found(texts, options.plc_clock));
  }
  if (options.clock != RunOptions::Clock::automatic || !has_real_link(links)) return {};
  for (const link::LinkSettings& settings : program.link_settings) {
    const std::uint32_t symbol = settings.clock.symbol;
    if (symbol == link::ClockSettings::kNone) continue;
    const std::string_view name = tables::split_names(tables.symbol_names)[2 * std::size_t{symbol}];
    if (link_of(symbol, links, tables)) return choose(symbol, name, std::nullopt, links, tables);
    return {std::nullopt, "",
            fmt::format("plant time does not follow the clock `{}`, since its PLC has no link in this run", name)};
  }
  return {};
}

ReportedPlcTime::ReportedPlcTime(const PlcClockChoice& choice, const plant::Plant& plant, const Links& links,
                                 trace::Recorder& recorder)
    : PlcTime(choice.clock, plant, plant.tables().symbols[choice.symbol].index, *links[choice.link].link),
      recorder_(recorder),
      symbol_(choice.symbol) {}

void ReportedPlcTime::restarted(const plant::Plant& plant) noexcept {
  recorder_.raise(plant.now(), tables::FindingKind::clock_restarted, symbol_);
}

}  // namespace symplant::host

// Findings about the maps of a plant's links.
#include "app/map_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "app/map_notes.hpp"
#include "check/rules.hpp"
#include "description/description_rules.hpp"
#include "symplant/link/io_map.hpp"
#include "symplant/tables/names.hpp"
#include "text/ascii.hpp"

namespace symplant::app {
namespace {

using Kind = link::MapFault::Kind;

/// "/links/0": the link that has the settings of a controller.
description::Pointer link_pointer(const model::PlantModel& plant, std::uint32_t controller) {
  const auto& links = plant.description->links;
  const auto is_its = [&](const description::LinkDescription& link) {
    return link.has_settings &&
           (link.controller.empty() ? plant.controllers.size() == 1 || plant.controllers[controller].empty()
                                    : text::equal_ignoring_case(link.controller, plant.controllers[controller]));
  };
  const auto found = std::find_if(links.begin(), links.end(), is_its);
  return description::Pointer("/links") / static_cast<std::size_t>(found - links.begin());
}

constexpr std::array<std::string_view, link::kTables> kSizeKeys{"coils", "discrete-inputs", "holding-registers",
                                                                "input-registers"};

/// The key that the user must change.
description::Pointer key_of(Kind kind, const description::Pointer& link) {
  switch (kind) {
    case Kind::status_overlap:
    case Kind::status_beyond:
      return link / "status";
    case Kind::watchdog_overlap:
    case Kind::watchdog_beyond:
      return link / "watchdog";
    case Kind::overlap:
    case Kind::beyond_size:
    case Kind::beyond_end:
      break;
  }
  return link;
}

/// Adds one fault for each table whose size is too small, however many symbols are beyond it.
void add_size_faults(const tables::PlantTables& tables, const link::IoMap& map, const description::Pointer& link,
                     std::vector<description::DescriptionFault>& faults) {
  std::array<const link::IoPoint*, link::kTables> last{};
  std::array<std::size_t, link::kTables> count{};
  for (const link::MapFault& fault : map.faults) {
    if (fault.kind != Kind::beyond_size) continue;
    const auto point = std::find_if(map.points.begin(), map.points.end(),
                                    [&](const link::IoPoint& p) { return p.symbol == fault.symbol; });
    if (point == map.points.end()) continue;
    const auto table = static_cast<std::size_t>(point->table);
    ++count[table];
    if (last[table] == nullptr || last[table]->last() < point->last()) last[table] = &*point;
  }
  const std::vector<std::string_view> texts = tables::split_names(tables.symbol_names);
  for (std::size_t t = 0; t < link::kTables; ++t) {
    if (last[t] == nullptr) continue;
    faults.push_back(
        {(link / "size" / kSizeKeys[t]).text(),
         fmt::format("{} {} beyond the size of {}, the last is `{}` on {}: give a size of {} or more, or omit the size",
                     count[t], count[t] == 1 ? "symbol is" : "symbols are", map.sizes[t],
                     texts[std::size_t{last[t]->symbol} * 2], address_text(*last[t]), last[t]->last() + 1),
         0, description::FaultKind::contradiction});
  }
}

}  // namespace

bool symbols_can_overlap(const model::PlantModel& plant) {
  const bool is_set = std::any_of(plant.description->links.begin(), plant.description->links.end(),
                                  [](const description::LinkDescription& link) { return link.has_settings; });
  return is_set || std::any_of(plant.symbols.begin(), plant.symbols.end(),
                               [](const model::Symbol& symbol) { return link::width_of(symbol.type) > 1; });
}

void add_map_findings(const model::PlantModel& plant, const lower::EngineTables& lowered,
                      diag::Diagnostics& diagnostics) {
  const tables::PlantTables tables = lowered.tables();
  std::vector<description::DescriptionFault> faults;
  for (std::uint32_t controller = 0; controller < plant.links.size(); ++controller) {
    const link::IoMap map = link::make_io_map(tables, controller, plant.links[controller].settings());
    add_size_faults(tables, map, link_pointer(plant, controller), faults);
    for (const link::MapFault& fault : map.faults) {
      if (fault.kind == Kind::beyond_size || fault.kind == Kind::beyond_end) continue;  // already reported
      std::string message = link::fault_text(tables, map, fault);
      if (fault.kind != Kind::overlap) {
        faults.push_back({key_of(fault.kind, link_pointer(plant, controller)).text(), std::move(message), 0,
                          description::FaultKind::contradiction});
        continue;
      }
      const model::Symbol& other = plant.symbols[fault.symbol];
      const model::Symbol& symbol = plant.symbols[fault.other];
      diagnostics.add(check::kSymbolsOverlap.info, check::about(symbol), std::move(message),
                      check::location_of(plant, *symbol.row, symbol.address_cell),
                      {{check::location_of(plant, *other.row, other.address_cell), "the other symbol"}});
    }
  }
  if (!faults.empty()) description::add_findings(plant.description_source, faults, diagnostics);
}

}  // namespace symplant::app

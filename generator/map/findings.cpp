// Findings about the maps of a plant's links.
#include "map/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <variant>

#include "check/catalogue.hpp"
#include "check/rule.hpp"
#include "description/description_rules.hpp"
#include "symplant/link/client_parts.hpp"
#include "symplant/link/modbus/io_map.hpp"
#include "symplant/tables/names.hpp"
#include "text/ascii.hpp"

namespace symplant::map {
namespace {

using Kind = link::modbus::MapFault::Kind;

constexpr std::uint64_t kAddresses = 65'536;  ///< of a table

bool is_link_of(const model::PlantModel& plant, std::uint32_t controller, const description::LinkDescription& link) {
  if (!link.controller.empty()) return text::equal_ignoring_case(link.controller, plant.controllers[controller]);
  return plant.controllers.size() == 1 || plant.controllers[controller].empty();
}

/// "/links/0": the link that has the settings of a controller.
description::Pointer link_pointer(const model::PlantModel& plant, std::uint32_t controller) {
  const auto& links = plant.description->links;
  const auto found = std::find_if(links.begin(), links.end(), [&](const description::LinkDescription& link) {
    return link.has_settings && is_link_of(plant, controller, link);
  });
  return description::Pointer("/links") / static_cast<std::size_t>(found - links.begin());
}

/// Whether a link of the controller goes to the PLC: then the addresses there count, not Modbus numbers. Adds a fault
/// if its URL does not fit the plant.
bool check_client(const model::PlantModel& plant, const tables::PlantTables& tables, std::uint32_t controller,
                  std::vector<description::DescriptionFault>& faults) {
  const description::LinkDescription* const found = client_link_of(plant, controller);
  if (found == nullptr) return false;
  const auto parts = link::client_parts({found->url, controller, plant.links[controller].settings()}, tables);
  if (const auto* error = std::get_if<link::LinkError>(&parts);
      error != nullptr && link::url_fault(found->url).empty()) {
    const auto index = static_cast<std::size_t>(found - plant.description->links.data());
    const auto pointer = description::Pointer("/links") / index / "url";
    faults.push_back({pointer.text(), error->message, 0, description::FaultKind::contradiction});
  }
  return true;
}

constexpr std::array<std::string_view, link::modbus::kTables> kSizeKeys{"coils", "discrete-inputs", "holding-registers",
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
void add_size_faults(const tables::PlantTables& tables, const link::modbus::IoMap& map,
                     const description::Pointer& link, std::vector<description::DescriptionFault>& faults) {
  std::array<const link::modbus::IoPoint*, link::modbus::kTables> last{};
  std::array<std::size_t, link::modbus::kTables> count{};
  for (const link::modbus::MapFault& fault : map.faults) {
    if (fault.kind != Kind::beyond_size) continue;
    const auto point = std::find_if(map.points.begin(), map.points.end(),
                                    [&](const link::modbus::IoPoint& p) { return p.symbol == fault.symbol; });
    if (point == map.points.end()) continue;
    const auto table = static_cast<std::size_t>(point->table);
    ++count[table];
    if (last[table] == nullptr || last[table]->last() < point->last()) last[table] = &*point;
  }
  const std::vector<std::string_view> texts = tables::split_names(tables.symbol_names);
  for (std::size_t t = 0; t < link::modbus::kTables; ++t) {
    if (last[t] == nullptr) continue;
    faults.push_back(
        {(link / "size" / kSizeKeys[t]).text(),
         fmt::format("{} {} beyond the size of {}, the last is `{}` on {}: give a size of {} or more, or omit the size",
                     count[t], count[t] == 1 ? "symbol is" : "symbols are", map.sizes[t],
                     texts[std::size_t{last[t]->symbol} * 2], link::modbus::location_text(*last[t]),
                     last[t]->last() + 1),
         0, description::FaultKind::contradiction});
  }
}

/// The bit of an address with two parts, `%IX0.9`, as its last part says; nothing for all others.
std::optional<int> bit_of_two_parts(std::string_view address) {
  const std::size_t dot = address.find('.');
  if (!address.starts_with('%') || dot == std::string_view::npos || dot != address.rfind('.')) return std::nullopt;
  const std::string_view digits = address.substr(dot + 1);
  int bit = 0;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), bit);
  return fault == std::errc() && end == digits.data() + digits.size() ? std::optional(bit) : std::nullopt;
}

constexpr int kBitsOfByte = 8;

bool is_beyond_byte(std::string_view address) { return bit_of_two_parts(address).value_or(0) >= kBitsOfByte; }

/// Why an address has no number.
std::string reason_of(std::string_view address) {
  if (is_beyond_byte(address)) return fmt::format("a byte has no bit {}", *bit_of_two_parts(address));
  if (std::count(address.begin(), address.end(), '.') > 1) return "it has more than two parts";
  return "it is of another form, or 65536 or more";
}

/// Of each packed table, the symbols whose addresses have no number, if some of its symbols have one, or if an address
/// looks as if it had one. A table in which no address has a number is packed as a whole.
void add_packed_findings(const model::PlantModel& plant, const tables::PlantTables& tables, std::uint32_t controller,
                         const link::modbus::IoMap& map, diag::Diagnostics& diagnostics) {
  std::array<std::size_t, link::modbus::kTables> numbered{};
  std::array<std::vector<const model::Symbol*>, link::modbus::kTables> others;
  std::vector<bool> given(plant.symbols.size());
  for (const link::MapRow& row : plant.links[controller].rows) given[row.symbol] = row.number != link::MapRow::kDefault;
  for (std::uint32_t i = 0; i < plant.symbols.size(); ++i) {
    const model::Symbol& symbol = plant.symbols[i];
    const auto t = static_cast<std::size_t>(link::image::plane_of(tables.symbols[i]));
    const bool linked = tables.symbols[i].form() != tables::AddressForm::none && !link::modbus::is_8_bits(symbol.type);
    if (!map.packed[t] || given[i] || !linked || plant.controller_of(symbol) != controller) continue;
    if (link::modbus::own_number(tables.symbols[i]) != tables::kNone) {
      ++numbered[t];
    } else {
      others[t].push_back(&symbol);
    }
  }
  for (std::size_t t = 0; t < link::modbus::kTables; ++t) {
    const auto beyond = std::find_if(others[t].begin(), others[t].end(), [](const model::Symbol* symbol) {
      return is_beyond_byte(symbol->address_cell());
    });
    if (others[t].empty() || (numbered[t] == 0 && beyond == others[t].end())) continue;
    if (beyond != others[t].end()) std::rotate(others[t].begin(), beyond, beyond + 1);
    const model::Symbol& symbol = *others[t].front();
    std::vector<diag::Related> related;
    for (std::size_t i = 1; i < std::min<std::size_t>(others[t].size(), 10); ++i) {
      const model::Symbol& other = *others[t][i];
      related.push_back({check::location_of(plant, *other.row, other.address_cell()), "this one has no number either"});
    }
    diagnostics.add(
        *check::find_rule("SP317"), check::about(symbol),
        fmt::format("`{}` has no number on a link, because {}; so {} other {}s are in list order and do not "
                    "have their own numbers: correct this address, or give `{}` a `number` in `links`",
                    symbol.address_cell(), reason_of(symbol.address_cell()), numbered[t] + others[t].size() - 1,
                    link::modbus::table_name(static_cast<link::modbus::Table>(t)), symbol.name()),
        check::location_of(plant, *symbol.row, symbol.address_cell()), std::move(related));
  }
}

}  // namespace

const description::LinkDescription* link_of(const model::PlantModel& plant, std::uint32_t controller) {
  if (const auto* const client = client_link_of(plant, controller)) return client;
  for (const description::LinkDescription& link : plant.description->links) {
    if (is_link_of(plant, controller, link)) return &link;
  }
  return nullptr;
}

const description::LinkDescription* client_link_of(const model::PlantModel& plant, std::uint32_t controller) {
  for (const description::LinkDescription& link : plant.description->links) {
    if (link::is_client(link.url) && is_link_of(plant, controller, link)) return &link;
  }
  return nullptr;
}

bool map_can_have_findings(const model::PlantModel& plant) {
  const bool is_set = std::any_of(
      plant.description->links.begin(), plant.description->links.end(),
      [](const description::LinkDescription& link) { return link.has_settings || link::is_client(link.url); });
  std::size_t odd = 0;
  bool wide = false;
  bool beyond_byte = false;
  for (const model::Symbol& symbol : plant.symbols) {
    beyond_byte = beyond_byte || (symbol.address && is_beyond_byte(symbol.address_cell()));
    odd += symbol.address && (!symbol.address->plain || symbol.address->number >= kAddresses) ? 1U : 0U;
    wide = wide || link::image::words_of(symbol.type) > 1;
  }
  return is_set || wide || beyond_byte || (odd != 0 && odd < plant.symbols.size());
}

void add_map_findings(const model::PlantModel& plant, const lower::EngineTables& lowered,
                      diag::Diagnostics& diagnostics) {
  const tables::PlantTables tables = lowered.tables();
  std::vector<description::DescriptionFault> faults;
  for (std::uint32_t controller = 0; controller < plant.links.size(); ++controller) {
    if (check_client(plant, tables, controller, faults)) continue;
    const link::modbus::IoMap map = link::modbus::make_io_map(tables, controller, plant.links[controller].settings());
    add_size_faults(tables, map, link_pointer(plant, controller), faults);
    add_packed_findings(plant, tables, controller, map, diagnostics);
    for (const link::modbus::MapFault& fault : map.faults) {
      if (fault.kind == Kind::beyond_size || fault.kind == Kind::beyond_end) continue;  // already reported
      std::string message = link::modbus::fault_text(tables, map, fault);
      if (fault.kind != Kind::overlap) {
        faults.push_back({key_of(fault.kind, link_pointer(plant, controller)).text(), std::move(message), 0,
                          description::FaultKind::contradiction});
        continue;
      }
      const model::Symbol& other = plant.symbols[fault.symbol];
      const model::Symbol& symbol = plant.symbols[fault.other];
      diagnostics.add(*check::find_rule("SP316"), check::about(symbol), std::move(message),
                      check::location_of(plant, *symbol.row, symbol.address_cell()),
                      {{check::location_of(plant, *other.row, other.address_cell()), "the other symbol"}});
    }
  }
  if (!faults.empty()) description::add_findings(*plant.description_source, faults, diagnostics);
}

}  // namespace symplant::map

// The settings of a Modbus client link.
#include "symplant/link/modbus/client_settings.hpp"

#include <string>
#include <utility>

#include "symplant/link/url_values.hpp"

namespace symplant::link::modbus {

namespace {

constexpr std::array kAreaKeys = {std::pair{std::string_view("coils"), Area::coils},
                                  std::pair{std::string_view("discrete-inputs"), Area::discrete_inputs},
                                  std::pair{std::string_view("holding-registers"), Area::holding_registers},
                                  std::pair{std::string_view("input-registers"), Area::input_registers}};

/// Whether a table of the map may be in an area: events must be written unless the link only reads, numbers need
/// registers.
constexpr bool fits(Table table, Area area, bool reads_only) {
  if (!reads_only && is_event(table) && area != Area::coils && area != Area::holding_registers) return false;
  return has_bits(table) || !has_bits(area);
}

/// `AREA` or `AREA:OFFSET`.
template <Table table>
Problem read_placement(std::string_view text, ClientSettings& settings) {
  const std::size_t colon = text.find(':');
  Placement placement;
  Problem problem = choose(kAreaKeys, text.substr(0, colon), placement.area);
  if (!problem.empty() || !fits(table, placement.area, settings.reads_only)) {
    std::string areas;
    for (const auto& [name, area] : kAreaKeys) {
      if (fits(table, area, settings.reads_only)) areas.append(areas.empty() ? "" : ", ").append(name);
    }
    return "write an area, and the address of number 0 if it is not 0, as in `holding-registers:1024`; here the area "
           "may be " +
           areas;
  }
  if (colon != std::string_view::npos) problem = read_number(text.substr(colon + 1), 65'535, placement.offset);
  if (!problem.empty()) return "after the colon " + problem;
  settings.placements[static_cast<std::size_t>(table)] = placement;
  return {};
}

Problem read_unit(std::string_view text, ClientSettings& settings) {
  std::uint32_t unit = 0;
  Problem problem = read_number(text, 255, unit);
  settings.unit = static_cast<std::uint8_t>(unit);
  return problem;
}

Problem read_bit_order(std::string_view text, ClientSettings& settings) {
  constexpr std::array kOrders = {std::pair{std::string_view("low-first"), BitOrder::low_first},
                                  std::pair{std::string_view("high-first"), BitOrder::high_first}};
  return choose(kOrders, text, settings.bit_order);
}

Problem read_bytes(std::string_view text, ClientSettings& settings) {
  constexpr std::array kOrders = {std::pair{std::string_view("normal"), ByteOrder::high_first},
                                  std::pair{std::string_view("swapped"), ByteOrder::low_first}};
  return choose(kOrders, text, settings.byte_order);
}

using ClientKey = UrlKey<ClientSettings>;
constexpr std::array kClientKeys = {
    ClientKey{"unit", read_unit},
    ClientKey{"operations", read_placement<Table::coil>},
    ClientKey{"events", read_placement<Table::discrete_input>},
    ClientKey{"operation-values", read_placement<Table::holding_register>},
    ClientKey{"event-values", read_placement<Table::input_register>},
    ClientKey{"bit-order", read_bit_order},
    ClientKey{"bytes", read_bytes},
    ClientKey{"poll", [](std::string_view text, ClientSettings& s) { return read_time(text, s.times.poll, false); }},
    ClientKey{"refresh",
              [](std::string_view text, ClientSettings& s) { return read_time(text, s.times.refresh, false); }},
    ClientKey{"read-back",
              [](std::string_view text, ClientSettings& s) { return read_time(text, s.times.read_back, true); }},
    ClientKey{"retry",
              [](std::string_view text, ClientSettings& s) { return read_time(text, s.times.first_retry, false); }},
    ClientKey{"timeout", [](std::string_view text, ClientSettings& s) { return read_time(text, s.timeout, false); }},
    ClientKey{"at-end",
              [](std::string_view text, ClientSettings& s) { return read_at_end(text, s.times.zero_at_end); }},
};

}  // namespace

const char* area_name(Area area) {
  constexpr std::array<const char*, kAreas> kNames = {"coil", "discrete input", "holding register", "input register"};
  return kNames[static_cast<std::size_t>(area)];
}

std::variant<ClientSettings, LinkError> read_client_settings(std::string_view rest, bool reads_only) {
  auto url = parse_url(rest, "modbus-tcp");
  if (auto* error = std::get_if<LinkError>(&url)) return std::move(*error);
  auto& parsed = std::get<ParsedUrl>(url);
  ClientSettings settings;
  settings.address = std::move(parsed.address);
  settings.reads_only = reads_only;
  if (reads_only) {
    settings.placements = {Placement{Area::coils}, Placement{Area::discrete_inputs}, Placement{Area::holding_registers},
                           Placement{Area::input_registers}};
  }
  for (const UrlParameter& parameter : parsed.parameters) {
    Problem problem =
        read_parameter(parameter, kClientKeys, settings, "a link `modbus-tcp`", "docs/links.md#modbus-client");
    if (!problem.empty()) return LinkError{LinkError::Kind::usage, std::move(problem)};
  }
  return settings;
}

}  // namespace symplant::link::modbus

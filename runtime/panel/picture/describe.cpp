// The description of a plant for the panel's clients.
#include "symplant/panel/picture/describe.hpp"

#include <algorithm>
#include <array>

#include "symplant/condition/compare.hpp"
#include "symplant/link/link.hpp"
#include "symplant/panel/picture/describe_values.hpp"
#include "symplant/panel/picture/drivers.hpp"
#include "symplant/panel/picture/json_text.hpp"
#include "symplant/panel/picture/stations.hpp"
#include "symplant/panel/picture/value_states.hpp"
#include "symplant/tables/lists.hpp"
#include "symplant/tables/names.hpp"
#include "symplant/trace/malfunction_marks.hpp"
#include "symplant/why/driven_things.hpp"

namespace symplant::panel {
namespace {

using tables::kNone;

std::string_view actuation_name(tables::Actuation actuation) {
  switch (actuation) {
    case tables::Actuation::latched:
      return "latched";
    case tables::Actuation::bistable:
      return "bistable";
    case tables::Actuation::held:
      return "held";
    case tables::Actuation::spring:
      break;
  }
  return "spring";
}

void put_stations(std::string& json, const Stations& stations) {
  put_key(json, "stations");
  json += '[';
  for (const Station& station : stations.stations) {
    put_comma(json);
    json += '{';
    put_member(json, "name", station.name());
    put_member(json, "line", station.line);
    put_member(json, "process", station.process);
    json += '}';
  }
  json += ']';
}

void put_device(std::string& json, std::uint32_t unit, const trace::PlantNames& names, const Stations& stations,
                const View& view) {
  const tables::TypeRow& type = names.tables().types[names.tables().units[unit].type];
  json += '{';
  put_member(json, "name", names.unit(unit));
  put_member(json, "label", stations.labels[unit]);
  put(json, ",\"station\":{}", stations.of_unit[unit]);
  put_member(json, "shape", tables::shape_name(view.shapes.empty() ? tables::Shape::device : view.shapes[unit]));
  put_key(json, "states");
  json += '[';
  for (const std::string_view state : names.states(unit)) {
    put_comma(json);
    put_text(json, state);
  }
  put(json, "],\"rest\":{},\"actuation\":\"{}\",\"operations\":[", index_or_null(type.rest, tables::kNoState),
      actuation_name(type.actuation));
  std::vector<std::uint32_t> events;
  std::size_t operation = 0;
  for (const std::uint32_t symbol : names.symbols_of(unit)) {
    if (!names.is_operation(symbol)) {
      events.push_back(symbol);
      continue;
    }
    put_comma(json);
    put(json, "{{\"symbol\":{},\"to\":{}}}", symbol,
        index_or_null(type.operation_targets[operation++], tables::kNoState));
  }
  json += ']';
  put_indexes(json, "events", events);
  if (!view.devices.empty() && view.devices[unit].x != kNotPlaced) {
    put(json, ",\"view\":{{\"x\":{},\"y\":{}}}", view.devices[unit].x, view.devices[unit].y);
  }
  json += '}';
}

/// The link of a symbol; kNone if it is on none.
std::uint32_t link_of(const tables::PlantTables& tables, std::uint32_t symbol, const std::vector<LinkName>& links) {
  if (tables.symbols[symbol].form() == tables::AddressForm::none) return kNone;
  const std::uint32_t controller = tables::controller_of(tables, symbol);
  const auto carries = [&](const LinkName& link) {
    return link.carries == link::kAllControllers || link.carries == controller;
  };
  const auto found = std::find_if(links.begin(), links.end(), carries);
  return found == links.end() ? kNone : static_cast<std::uint32_t>(found - links.begin());
}

void put_drives(std::string& json, const std::vector<std::string>& things) {
  put_key(json, "drives");
  json += '[';
  for (const std::string& thing : things) {
    put_comma(json);
    put_text(json, thing);
  }
  json += ']';
}

/// The program that writes an operation.
void put_program(std::string& json, std::uint32_t symbol, const trace::PlantNames& names) {
  const auto programs = names.programs();
  for (std::size_t i = 0; i < programs.size(); ++i) {
    if (programs[i].written[symbol]) put(json, ",\"program\":{}", i);
  }
}

void put_programs(std::string& json, const trace::PlantNames& names) {
  const auto controllers = tables::split_names(names.tables().controller_names);
  put_key(json, "programs");
  json += '[';
  for (const trace::PlantNames::Program& program : names.programs()) {
    put_comma(json);
    json += '{';
    put_member(json, "name", program.name);
    put_member(json, "controller",
               program.controller < controllers.size() ? std::string(controllers[program.controller]) : std::string());
    put(json, ",\"period\":{}}}", program.period);
  }
  json += ']';
}

/// The comment of a symbol, and whether a person operates it: each only if it is so.
void put_symbol_view(std::string& json, std::uint32_t symbol, const View& view) {
  if (view.symbols.empty()) return;
  const SymbolView& of = view.symbols[symbol];
  if (!of.comment.empty()) put_member(json, "comment", of.comment);
  if (of.by_operator) json += ",\"operator\":true";
}

void put_symbols(std::string& json, const trace::PlantNames& names, const View& view,
                 const std::vector<LinkName>& links, Role role) {
  const tables::PlantTables& tables = names.tables();
  const why::SymbolUse use(tables);
  const std::vector<std::string_view> drivers = drivers_of(tables);
  put_key(json, "symbols");
  json += '[';
  for (std::uint32_t symbol = 0; symbol < tables.symbols.size(); ++symbol) {
    const tables::SymbolRow& row = tables.symbols[symbol];
    const bool operation = names.is_operation(symbol);
    put_comma(json);
    json += '{';
    put_member(json, "name", names.symbol(symbol));
    put_member(json, "address", names.address(symbol));
    put(json, R"(,"type":"{}","direction":"{}","device":{},"driver":)", condition::type_name(row.type()),
        operation ? "operation" : "event", index_or_null(row.unit, kNone));
    if (operation) {
      json += "null";
      put_drives(json, why::driven_things(symbol, use, names, sees_all(role)));
    } else {
      put_text(json, drivers[symbol]);
    }
    put(json, ",\"link\":{}", index_or_null(link_of(tables, symbol, links), kNone));
    put_program(json, symbol, names);
    put_member(json, "list", names.cite(symbol));
    put(json, ",\"inverted\":{}", row.inverted());
    put_symbol_view(json, symbol, view);
    json += '}';
  }
  json += ']';
}

void put_sensors(std::string& json, const tables::MaterialTables& material, const tables::Rows& rows, bool on_track) {
  put_key(json, "sensors");
  json += '[';
  for (const tables::SensorRow& sensor : material.sensors.subspan(rows.first, rows.count)) {
    put_comma(json);
    put(json, "{{\"symbol\":{}", sensor.symbol);
    if (on_track) put(json, ",\"at\":{}", sensor.at);
    json += '}';
  }
  json += ']';
}

void put_track(std::string& json, const tables::MaterialTables& material, std::uint32_t track) {
  const tables::TrackRow& row = material.tracks[track];
  put(json, ",\"kind\":\"track\",\"length\":{},\"drives\":[", row.length);
  std::int64_t from = 0;
  for (const tables::DriveRow& drive : material.drives.subspan(row.drives.first, row.drives.count)) {
    put_comma(json);
    put(json, "{{\"from\":{},\"until\":{}}}", from, drive.until);
    from = drive.until;
  }
  json += "],\"stops\":[";
  for (const tables::StopRow& stop : material.stops.subspan(row.stops.first, row.stops.count)) {
    put_comma(json);
    put(json, "{{\"at\":{}}}", stop.at);
  }
  json += ']';
  put_sensors(json, material, row.sensors, true);
  json += ",\"ends\":[";
  for (const tables::EndRow& end : material.ends.subspan(row.ends.first, row.ends.count)) {
    put_comma(json);
    put(json, "{{\"to\":{}}}", index_or_null(end.to, tables::kOut));
  }
  json += ']';
}

std::string location_text(const tables::PartLocation& at) {
  std::string text = "{\"location\":" + index_or_null(at.location, tables::kOut);
  if (at.at != tables::kWhole) put(text, ",\"at\":{}", at.at);
  return text + "}";
}

void put_material(std::string& json, const trace::PlantNames& names) {
  const tables::MaterialTables& material = names.tables().material;
  put_key(json, "locations");
  json += '[';
  for (std::uint32_t location = 0; location < material.locations(); ++location) {
    put_comma(json);
    json += '{';
    put_member(json, "name", names.location(location));
    if (material.is_track(location)) {
      put_track(json, material, location);
    } else {
      const tables::PlaceRow& place = material.places[material.place_of(location)];
      put(json, ",\"kind\":\"place\",\"holds\":{}", place.holds);
      put_sensors(json, material, place.sensors, false);
    }
    json += '}';
  }
  json += "],\"transfers\":[";
  for (std::uint32_t i = 0; i < material.transfers.size(); ++i) {
    put_comma(json);
    json += '{';
    put_member(json, "name", names.transfer(i));
    put(json, ",\"from\":{},\"to\":{}}}", location_text(material.transfers[i].from),
        location_text(material.transfers[i].to));
  }
  json += "],\"part_kinds\":[";
  for (std::uint32_t kind = 0; kind < material.kinds.size(); ++kind) {
    put_comma(json);
    json += '{';
    put_member(json, "name", names.part_kind(kind));
    put(json, ",\"length\":{}}}", material.kinds[kind].length);
  }
  json += ']';
}

/// The kinds of its effects, each once, in their order.
std::string kinds_of(const tables::MalfunctionTables& malfunctions, std::uint32_t malfunction) {
  constexpr std::array<std::string_view, 7> kNames{"slower", "stuck", "force", "flicker", "lose", "set", "distort"};
  std::string kinds;
  for (const tables::EffectRow& effect : malfunctions.effects_of(malfunction)) {
    const std::string_view name = kNames[static_cast<std::size_t>(effect.kind)];
    if (kinds.find(name) == kinds.npos) kinds.append(kinds.empty() ? "" : ", ").append(name);
  }
  return kinds;
}

/// Those of the plant description, and the kinds of those that every device and BOOL event has.
void put_malfunctions(std::string& json, const trace::PlantNames& names) {
  const tables::PlantTables& tables = names.tables();
  put_key(json, "malfunctions");
  json += '[';
  for (std::uint32_t m = 0; m < tables.malfunctions.size(); ++m) {
    const trace::ActsOn on = trace::acts_on(tables, m);
    put_comma(json);
    json += '{';
    put_member(json, "name", names.malfunction(m));
    put_member(json, "kind", kinds_of(tables.malfunctions, m));
    put_indexes(json, "devices", on.units);
    put_indexes(json, "symbols", on.symbols);
    if (!tables.values.rows.empty()) put_indexes(json, "values", held_outputs(tables, m));
    json += '}';
  }
  json += R"(],"ordinary":{"device":["stuck","slow"],"event":["stuck on","stuck off"]})";
}

}  // namespace

void put_plant(std::string& json, const trace::PlantNames& names, const View& view, const std::vector<LinkName>& links,
               Role role) {
  const tables::PlantTables& tables = names.tables();
  const Stations stations = stations_of(names, view);
  put_stations(json, stations);
  put_key(json, "devices");
  json += '[';
  for (std::uint32_t unit = 0; unit < tables.units.size(); ++unit) {
    put_comma(json);
    put_device(json, unit, names, stations, view);
  }
  json += ']';
  put_symbols(json, names, view, links, role);
  put_values(json, names);
  put_material(json, names);
  put_key(json, "requirements");
  json += '[';
  for (std::uint32_t r = 0; r < tables.requirements.size(); ++r) {
    put_comma(json);
    json += '{';
    put_member(json, "name", names.requirement(r));
    put(json, ",\"kind\":\"{}\"}}",
        tables.requirements[r].kind == tables::RequirementRow::Kind::never ? "never" : "expect");
  }
  json += ']';
  if (sees_all(role)) put_malfunctions(json, names);
  put_key(json, "links");
  json += '[';
  for (const LinkName& link : links) {
    put_comma(json);
    json += '{';
    put_member(json, "name", link.url);
    put_member(json, "controller", link.controller);
    json += '}';
  }
  json += ']';
  put_programs(json, names);
  if (!view.view3d.empty()) {
    put_key(json, "view3d");
    json += view.view3d;
  }
}

}  // namespace symplant::panel

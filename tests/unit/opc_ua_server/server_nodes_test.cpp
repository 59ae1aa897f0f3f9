// The names of the server's nodes, units, malfunctions, and the symbols that it carries.
#include "symplant/link/opc_ua/server_nodes.hpp"

#include "support/catch.hpp"
#include "symplant/link/link_map.hpp"
#include "symplant/link/opc_ua/carried.hpp"
#include "symplant/link/opc_ua/engineering_units.hpp"
#include "symplant/link/opc_ua/malfunction_index.hpp"
#include "symplant/tables/malfunction_numbers.hpp"
#include "unit/exec/cell.hpp"

using namespace symplant;
using namespace symplant::link::opc_ua;

TEST_CASE("A device lies in the folders of its line and its process") {
  const Station station = station_of("EXLINE_MB_AGV_LIFT");
  CHECK(line_node(station) == "/line/EXLINE");
  CHECK(process_node(station) == "/process/EXLINE_MB");
  CHECK(station.rest == "AGV_LIFT");
  CHECK(station_of("LINE_PUMP").line == "LINE");
  CHECK(station_of("LINE_PUMP").process.empty());
  CHECK(station_of("LINE_PUMP").rest == "PUMP");
  CHECK(station_of("PUMP").line.empty());
  CHECK(station_of("PUMP").rest == "PUMP");
}

TEST_CASE("The namespace has the plant's name, as a URI may have it") {
  CHECK(plant_uri("urn:symplant:", "cell_2.b") == "urn:symplant:cell_2.b");
  CHECK(plant_uri("urn:symplant:", "my cell/ä") == "urn:symplant:my-cell---");
  CHECK(plant_uri("urn:symplant:", "") == "urn:symplant:plant");
}

TEST_CASE("A unit has the number of its code of UN/CEFACT") {
  CHECK(engineering_unit("mm").id == 5'066'068);  // MMT
  CHECK(engineering_unit("°C").id == 4'408'652);  // CEL
  CHECK(engineering_unit("%").id == 20'529);      // P1
  CHECK(engineering_unit("l/s").description == "litre per second");
  CHECK(engineering_unit("furlong").id == -1);
  CHECK(engineering_unit("furlong").description.empty());
}

TEST_CASE("A malfunction is found by its name without regard to case") {
  const tables::PlantTables tables = test::cell_tables();
  const MalfunctionIndex index(tables);
  const tables::MalfunctionNumbers numbers(tables);
  const std::string agv(tables.unit_names.substr(0, tables.unit_names.find('\0')));
  const std::string sensor(tables.symbol_names.substr(0, tables.symbol_names.find('\0')));
  CHECK(index.find(agv + " stuck") == numbers.stuck(0));
  CHECK(index.find(agv + " SLOW") == numbers.slow(0));
  CHECK(index.find(sensor + " stuck on") == numbers.stuck(0, true));
  CHECK(index.find(sensor + " Stuck Off") == numbers.stuck(0, false));
  CHECK_FALSE(index.find(agv));
  CHECK_FALSE(index.find(agv + " stuck on"));
  CHECK_FALSE(index.find(""));
}

TEST_CASE("The server carries every symbol of the controller by its name, except those that are excluded") {
  const tables::PlantTables tables = test::cell_tables();
  link::MapRow excluded;
  excluded.symbol = 1;
  excluded.excluded = true;
  link::LinkSettings settings;
  settings.rows = {&excluded, 1};
  const auto map = link::map_of({"opc-ua-server://127.0.0.1:4840", 0, settings}, tables);
  REQUIRE(std::holds_alternative<link::LinkMap>(map));
  const auto& made = std::get<link::LinkMap>(map);
  CHECK(made.symbols.size() == tables.symbols.size() - 1);
  CHECK(made.symbols.front().location ==
        "ns=2;s=" + std::string(tables.symbol_names.substr(0, tables.symbol_names.find('\0'))));
  REQUIRE(made.left_out.size() == 1);
  CHECK(made.left_out.front().symbol == 1);
  CHECK(made.where == "node id");
}

TEST_CASE("Symbols that share an address share a position") {
  tables::PlantTables tables = test::cell_tables();
  constexpr tables::SharedAddress kShared{1, 0};
  tables.shared_addresses = {&kShared, 1};
  const auto map = carried_symbols(tables, 0, {}).map;
  CHECK(map.points[1].position == map.points[0].position);
  CHECK(map.size(link::Plane::event_bits) + 1 == test::cell::kSymbols.size() / 2);
}

// Utilization over the panel's interface.
#include <numeric>

#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

TEST_CASE("Utilization has a row for each device, whose times add up to the time since the start") {
  const PanelBench bench;
  bench.act(R"({"set":{"L_P_AGV_O_P2":true}})");
  bench.wait_for([&] { return bench.device("AGV").at(0) == 1; });
  bench.act(R"({"freeze":true})");
  const Json use = bench.get("/api/v1/utilization");
  CHECK(use.at("from") == 0);
  CHECK(use.at("to") == bench.picture().at("t"));
  REQUIRE(use.at("devices").size() == bench.tables.rows.units.size());
  for (const Json& device : use.at("devices")) {
    const std::vector<tables::Time> times = device.at(0);
    CHECK(std::accumulate(times.begin(), times.end(), tables::Time{0}) == use.at("to"));
  }
  const Json vehicle = use.at("devices").at(bench.tables.unit_index("AGV"));
  CHECK(vehicle.at(0).at(0) == tables::kSecond);  // of the move
  CHECK(vehicle.at(2) == 1);
}

TEST_CASE("Utilization of one device has its states and moves, and all of it is a table") {
  const PanelBench bench;
  bench.act(R"({"set":{"L_P_AGV_O_P2":true}})");
  bench.wait_for([&] { return bench.device("AGV").at(0) == 1; });
  const Json device = bench.get("/api/v1/utilization?device=" + std::to_string(bench.tables.unit_index("AGV")));
  CHECK(device.at("times").at("moving") == tables::kSecond);
  CHECK(device.at("moves").at(0).at("from") == "P1");
  CHECK(device.at("moves").at(0).at("mean") == tables::kSecond);
  CHECK(device.at("states").contains("P2"));
  const HttpAnswer table = bench.send(bench.request("GET", "/api/v1/utilization.csv"));
  CHECK(table.status == 200);
  CHECK(contains(table.head, "text/csv"));
  CHECK(contains(table.head, "utilization.csv"));
  CHECK(contains(table.body, "\ndevice,L_P_AGV,move,P1 to P2,1,"));
}

TEST_CASE("A device that does not exist has no utilization") {
  const PanelBench bench;
  CHECK(bench.send(bench.request("GET", "/api/v1/utilization?device=99")).status == 400);
  CHECK(bench.send(bench.request("GET", "/api/v1/utilization?device=x")).status == 400);
}

TEST_CASE("An act, a reset and a restore count utilization again") {
  const PanelBench bench;
  bench.act(R"({"set":{"L_P_AGV_O_P2":true}})");
  bench.act(R"({"freeze":true})");
  const tables::Time again = bench.act(R"({"count":"utilization"})");
  CHECK(bench.get("/api/v1/utilization").at("from") == again);
  CHECK(bench.picture().at("acts").back().at("act") == Json::parse(R"({"count":"utilization"})"));
  bench.act(R"({"snapshot":"here"})");
  bench.act(R"({"reset":true})");
  CHECK(bench.get("/api/v1/utilization").at("from") == 0);
  bench.act(R"({"restore":"here"})");
  CHECK(bench.get("/api/v1/utilization").at("from") == again);
}

}  // namespace
}  // namespace symplant::test

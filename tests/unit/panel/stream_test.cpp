// The stream of the panel: pictures, changes, clients that are late or die; charts.
#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

/// A client of the stream.
class StreamClient {
 public:
  explicit StreamClient(const PanelBench& bench) : client_(bench.port) {
    client_.send(bench.request("GET", "/api/v1/stream"));
    client_.read_until("\r\n\r\n");
  }
  /// The next event: its name, and its data.
  std::pair<std::string, Json> next() {
    std::string event = client_.read_until("\n\n");
    while (event.starts_with(":")) event = client_.read_until("\n\n");  // a comment
    const std::size_t data = event.find("\ndata: ");
    REQUIRE(data != std::string::npos);
    return {event.substr(7, data - 7), Json::parse(event.substr(data + 7))};
  }
  /// The first of `changes` with this key.
  Json next_with(const std::string& key) {
    for (int i = 0; i < 500; ++i) {
      auto [name, data] = next();
      if (data.contains(key)) return data.at(key);
    }
    FAIL("no event with " << key);
    return {};
  }

 private:
  HttpClient client_;
};

TEST_CASE("A stream begins with a picture, and goes on with what changes") {
  const PanelBench bench;
  bench.act(R"({"freeze":true})");
  StreamClient stream(bench);
  const auto [name, picture] = stream.next();
  CHECK(name == "picture");
  CHECK(picture.at("symbols").size() == bench.tables.rows.symbols.size());
  stream.next();  // what changed before the first client came
  bench.act(R"({"force":{"L_P_AGV_I_P2":true}})");
  const std::uint32_t symbol = bench.tables.symbol("AGV_I_P2");
  const Json symbols = stream.next_with("symbols");
  CHECK(symbols == Json::array({Json::array({symbol, true, 1, picture.at("t")})}));
}

TEST_CASE("The changes, one after the other, give the picture") {
  const PanelBench bench;
  StreamClient stream(bench);
  Json devices = stream.next().second.at("devices");
  Json symbols;
  bench.act(R"({"set":{"L_P_AGV_O_P2":true}})");
  bench.act(R"({"state":{"L_P_DOOR":"OPEN2"}})");
  tables::Time last = 0;
  for (int i = 0; i < 400 && devices.at(0).at(0) != 1; ++i) {
    const auto [name, data] = stream.next();
    CHECK(data.at("t") >= last);
    last = data.at("t");
    const Json changed = data.value("devices", Json::array());
    for (const Json& device : changed) {
      devices.at(device.at(0).get<std::size_t>()) = Json(device.begin() + 1, device.end());
    }
  }
  bench.act(R"({"freeze":true})");
  const Json now = bench.picture().at("devices");
  for (std::size_t i = 0; i < now.size(); ++i) {
    CHECK(devices.at(i).at(0) == now.at(i).at(0));
    CHECK(devices.at(i).at(4) == now.at(i).at(4));
  }
}

TEST_CASE("After a reset every client gets the picture") {
  const PanelBench bench;
  StreamClient stream(bench);
  CHECK(stream.next().first == "picture");
  bench.act(R"({"force":{"L_P_AGV_I_P2":true}})");
  bench.act(R"({"freeze":true},{"reset":true})");
  for (int i = 0; i < 100; ++i) {
    const auto [name, data] = stream.next();
    if (name != "picture") continue;
    CHECK(data.at("t") == 0);
    return;
  }
  FAIL("no picture");
}

TEST_CASE("A client that does not read gets a picture when it reads again, and others are not delayed") {
  PanelPlan plan;
  plan.options.patience = 60;  // it is closed after that
  for (int i = 0; i < 1500; ++i) plan.names.push_back("LAMP" + std::to_string(i) + "X_O_ON");
  const PanelBench bench(plan);
  StreamClient late(bench);
  late.next();
  StreamClient prompt(bench);
  prompt.next();
  std::string on;
  for (int i = 0; i < 1500; ++i) on += std::string(i == 0 ? "" : ",") + "\"L_P_LAMP" + std::to_string(i) + "X_O_ON\":";
  for (int turn = 0; turn < 60; ++turn) {  // more than the buffers of a connection take
    std::string set = on;
    for (std::size_t at = 0; (at = set.find("\":", at)) != std::string::npos; at += 2) {
      set.insert(at + 2, turn % 2 == 0 ? "true" : "false");
    }
    bench.act("{\"set\":{" + set + "}}");
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    if (turn % 10 == 0) prompt.next();
  }
  std::size_t pictures = 0;
  for (int i = 0; i < 400 && pictures == 0; ++i) pictures += late.next().first == "picture" ? 1U : 0U;
  CHECK(pictures == 1);
}

TEST_CASE("A browser that dies leaves the plant running") {
  const PanelBench bench;
  for (int i = 0; i < 20; ++i) {
    StreamClient stream(bench);
    stream.next();
  }
  {
    HttpClient half(bench.port);
    half.send(bench.request("POST", "/api/v1/acts", "{}").substr(0, 90));
  }
  const tables::Time at = bench.picture().at("t");
  bench.wait_for([&] { return bench.picture().at("t") > at; });
}

TEST_CASE("Findings and violated requirements are in the stream, with their words") {
  PanelPlan plan;
  plan.reported.description.requirements.push_back({"not both", "L_P_AGV_O_P1 and L_P_AGV_O_P2", "", "", 0});
  const PanelBench bench(plan);
  StreamClient stream(bench);
  stream.next();
  bench.act(R"({"set":{"L_P_AGV_O_P1":true,"L_P_AGV_O_P2":true}})");
  const Json requirement = stream.next_with("requirements").at(0);
  CHECK(requirement.at(0) == 0);
  CHECK(requirement.at(1) == "violated");
  CHECK(requirement.at(3) == 1);
  bool found = false;
  const Json findings = bench.picture().at("findings");
  for (const Json& finding : findings) {
    found = found || (finding.at("finding") == "requirement violated" && finding.at("of") == "not both" &&
                      finding.at("severity") == "error" && contains(finding.at("text").get<std::string>(), "AGV"));
  }
  CHECK(found);
}

TEST_CASE("A chart has the value at its start and each change, and goes on") {
  const PanelBench bench;
  bench.act(R"({"freeze":true})");
  const std::string symbol = std::to_string(bench.tables.symbol("AGV_O_P2"));
  const std::string wish =
      "/api/v1/chart?symbols=" + symbol + "&devices=" + std::to_string(bench.tables.unit_index("AGV"));
  const tables::Time first = bench.act(R"({"set":{"L_P_AGV_O_P2":true}})");
  Json chart = bench.get(wish + "&from=0");
  CHECK(chart.at("symbols").at(0) == Json::array({Json::array({0, false}), Json::array({first, true})}));
  CHECK(chart.at("devices").at(0) == Json::array({Json::array({0, 0, 0}), Json::array({first, 0, 1})}));
  bench.act(R"({"step":"cycle"})");
  bench.wait_for([&] { return bench.picture().at("t") > first; });
  const tables::Time second = bench.act(R"({"set":{"L_P_AGV_O_P2":false}})");
  const std::string after = "&after=" + std::to_string(chart.at("next").get<std::uint64_t>());
  chart = bench.get(wish + after);
  CHECK(chart.at("symbols").at(0) == Json::array({Json::array({second, false})}));
  CHECK(chart.at("devices").at(0).empty());
  chart = bench.get(wish + "&from=" + std::to_string(second + 1));
  CHECK(chart.at("symbols").at(0) == Json::array({Json::array({second + 1, false})}));
  bench.act(R"({"reset":true})");
  chart = bench.get(wish + after);  // from before the reset
  CHECK(chart.at("from") == 0);
  CHECK(chart.at("symbols").at(0) == Json::array({Json::array({0, false})}));
}

TEST_CASE("Parts on a track are shown with their speed, and where they stop") {
  PanelPlan plan;
  description::GivenMaterial& material = plan.reported.description.material;
  material.kinds.push_back({"raw", 100'000, 1});
  description::GivenTrack track;
  track.name = "BELT";
  track.length = 1'000'000;
  description::GivenDrive drive;
  drive.forward = "L_P_AGV.P2";
  drive.speed.speed = 500'000;
  track.drives.push_back(drive);
  track.stops.push_back({1'000'000, "L_P_AGV.P2"});
  material.tracks.push_back(track);
  const PanelBench bench(plan);
  bench.act(R"({"put":{"at":"BELT@300 mm","kind":"raw"}})");
  const Json still = bench.picture().at("tracks").at(0);
  CHECK(still.at(1) == Json::parse("[[1,0,350000,0]]"));
  CHECK(still.at(2) == Json::parse("[false]"));
  CHECK(still.at(3) == Json::parse("[0]"));
  const tables::Time begun = bench.act(R"({"state":{"L_P_AGV":"P2"}})");
  CHECK(bench.picture().at("tracks").at(0) ==
        Json::array({begun, Json::parse("[[1,0,350000,500000]]"), Json::parse("[true]"), Json::parse("[500000]")}));
  bench.wait_for([&] { return bench.picture().at("tracks").at(0).at(1) == Json::parse("[[1,0,1000000,0]]"); });
  CHECK(bench.picture().at("tracks").at(0).at(0) == begun + 1300 * kMs);
}

TEST_CASE("A move that stops midway, goes on, and turns round keeps its progress") {
  PanelPlan plan;
  plan.reported.device("AGV").actuation = tables::Actuation::held;
  plan.reported.on_command("AGV", "P2", "P1", fixed(2000 * kMs));
  const PanelBench bench(plan);
  bench.act(R"({"freeze":true},{"set":{"L_P_AGV_O_P2":true}})");
  const auto cycles = [&](int count) {
    for (int i = 0; i < count; ++i) {
      const tables::Time at = bench.picture().at("t");
      bench.act(R"({"step":"cycle"})");
      bench.wait_for([&] { return bench.picture().at("t") > at; });
    }
  };
  cycles(25);
  Json agv = bench.device("AGV");
  CHECK(agv.at(5) == 975 * kMs);
  CHECK(agv.at(6) == 1000 * kMs);
  bench.act(R"({"set":{"L_P_AGV_O_P2":false}})");
  cycles(3);
  agv = bench.device("AGV");
  CHECK(agv.at(2) == 3);  // moving, stopped midway
  CHECK(agv.at(5) == 975 * kMs);
  CHECK(agv.at(6) == 1000 * kMs);
  bench.act(R"({"set":{"L_P_AGV_O_P1":true}})");
  agv = bench.device("AGV");
  CHECK(agv.at(0) == 1);
  CHECK(agv.at(1) == 0);
  CHECK(agv.at(5) == 50 * kMs);  // a fortieth of 2 s
  CHECK(std::abs(agv.at(6).get<tables::Time>() - 2000 * kMs) < kMs);
}

TEST_CASE("The description has what the page draws") {
  const PanelBench bench;
  const Json plant = bench.get("/api/v1/plant");
  CHECK(plant.at("symplant-panel") == 1);
  CHECK(plant.at("stations") == Json::parse(R"([{"name":"L P","line":"L","process":"P"}])"));
  const Json agv = plant.at("devices").at(bench.tables.unit_index("AGV"));
  CHECK(agv.at("name") == "L_P_AGV");
  CHECK(agv.at("label") == "AGV");
  CHECK(agv.at("states") == Json::parse(R"(["P1","P2"])"));
  CHECK(agv.at("operations").size() == 2);
  CHECK(plant.at("symbols").at(bench.tables.symbol("EYE_I_ON")).at("driver") == "none");
  CHECK(plant.at("symbols").at(bench.tables.symbol("AGV_I_P1")).at("driver") == "device");
  CHECK(plant.at("symbols").at(bench.tables.symbol("AGV_O_P1")).at("driver").is_null());
  CHECK(bench.get("/api/v1/openapi.json").at("openapi") == "3.0.3");
}

}  // namespace
}  // namespace symplant::test

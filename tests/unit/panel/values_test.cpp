// Values in the panel: what clients see of them, set, malfunctions that hold them, and charts.
#include "description/plant_file.hpp"
#include "support/golden.hpp"
#include "symplant/panel/operate/output_copy.hpp"
#include "symplant/panel/recording/recording.hpp"
#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

/// A tank that fills while the AGV is in P2, and wind.
constexpr const char* kValues = R"("values":{
  "wind":{"unit":"m/s","start":4,"min":0,"max":30},
  "L_P_AGV.load":{"unit":"l","start":20,"min":0,"max":1000,"integral":"wind * L_P_AGV.P2","trace":"20ms"},
  "double":{"is":"2 * L_P_AGV.load","trace":false},
  "still":{"unit":"m","start":3,"ramp":"3","up":1,"down":2}})";

Reported with_values(const std::string& more = "") {
  auto reading = description::read_plant_file(
      std::string(R"({"symplant":1,"symbols":["a.csv"],)") + kValues + (more.empty() ? "" : "," + more) + "}", "stem");
  for (const description::DescriptionFault& fault : reading.faults) FAIL_CHECK(fault.pointer << ": " << fault.message);
  REQUIRE(reading.file);
  Reported reported;
  reported.description.values = std::move(reading.file->description.values);
  reported.description.signals = std::move(reading.file->description.signals);
  reported.description.malfunctions = std::move(reading.file->description.malfunctions);
  reported.description.material = std::move(reading.file->description.material);
  return reported;
}

PanelPlan plan_with_values(const std::string& more = "") {
  PanelPlan plan;
  plan.reported = with_values(more);
  return plan;
}

enum : std::size_t { kWind, kLoad, kDouble, kStill };

/// The number of a value in the picture.
double number(const PanelBench& bench, std::size_t value) {
  return bench.picture().at("values").at(value).at(0).get<double>();
}

/// The events of the stream.
class Stream {
 public:
  explicit Stream(const PanelBench& bench) : client_(bench.port) {
    client_.send(bench.request("GET", "/api/v1/stream"));
    client_.read_until("\r\n\r\n");
  }
  Json next() {
    for (;;) {
      const std::string event = client_.read_until("\n\n");
      REQUIRE(!event.empty());
      if (const std::size_t data = event.find("\ndata: "); data != event.npos)
        return Json::parse(event.substr(data + 7));
    }
  }

 private:
  HttpClient client_;
};

TEST_CASE("A drive is shown with the speed that its value and malfunctions of its track give it") {
  const PanelBench bench(plan_with_values(R"("material":{"kinds":{"box":{"length":"100 mm"}},"tracks":{"BELT":{
    "length":"1 m","drives":[{"speed":{"of":"wind","unit":"1 m/s"}}]}}},"malfunctions":[
    {"name":"worn","of":"BELT","slower":2},{"name":"jam","of":"BELT","stuck":true}])"));
  const auto speeds = [&] { return bench.picture().at("tracks").at(0).at(3); };
  bench.wait_for([&] { return speeds() == Json::parse("[4000000]"); });
  CHECK(bench.post(R"({"start":"worn"})").status == 200);
  bench.wait_for([&] { return speeds() == Json::parse("[2000000]"); });
  CHECK(bench.post(R"({"set":{"wind":3}})").status == 200);
  bench.wait_for([&] { return speeds() == Json::parse("[1500000]"); });
  CHECK(bench.post(R"({"start":"jam"})").status == 200);
  bench.wait_for([&] { return speeds() == Json::parse("[0]"); });
}

TEST_CASE("The description has each value with its unit, kind, range, formulas and device") {
  const PanelBench bench(plan_with_values());
  CHECK(bench.get("/api/v1/plant").at("values") == Json::parse(R"([
    {"name":"wind","unit":"m/s","kind":"parameter","min":0.0,"max":30.0,"settable":true,"formulas":[],"device":null,
     "trace":100000000},
    {"name":"L_P_AGV.load","unit":"l","kind":"integral","min":0.0,"max":1000.0,"settable":true,
     "formulas":["wind * L_P_AGV.P2"],"device":)" + std::to_string(bench.tables.unit_index("AGV")) +
                                                               R"(,"trace":20000000},
    {"name":"double","unit":"","kind":"is","min":null,"max":null,"settable":false,"formulas":["2 * L_P_AGV.load"],
     "device":null,"trace":null},
    {"name":"still","unit":"m","kind":"ramp","min":null,"max":null,"settable":true,"formulas":["3","1","2"],
     "device":null,"trace":100000000}])"));
}

TEST_CASE("Each output of a linear value is a value of the description, under its own name") {
  PanelPlan plan;
  auto reading = description::read_plant_file(
      R"({"symplant":1,"symbols":["a.csv"],"values":{"BOOM":{"linear":{"a":[[1]],"b":[[1]],"c":[[1],[2]],"u":["1"]}}}})",
      "stem");
  REQUIRE(reading.file);
  plan.reported.description.values = std::move(reading.file->description.values);
  const PanelBench bench(plan);
  const Json values = bench.get("/api/v1/plant").at("values");
  REQUIRE(values.size() == 2);
  CHECK(values.at(0).at("name") == "BOOM[1]");
  CHECK(values.at(1).at("name") == "BOOM[2]");
  CHECK(bench.picture().at("values").size() == 2);
}

TEST_CASE("A plant without values has none in its description, its picture and its stream") {
  const PanelBench bench;
  CHECK(bench.get("/api/v1/plant").at("values") == Json::array());
  CHECK_FALSE(bench.picture().contains("values"));
  Stream stream(bench);
  for (int i = 0; i < 3; ++i) CHECK_FALSE(stream.next().contains("values"));
}

TEST_CASE("The symbol of a signal is driven by it") {
  Reported reported = with_values(R"("signals":{"L_P_TANK_I_LEVEL":"L_P_AGV.load"})");
  std::vector<Row> rows = bits({"L_P_AGV_I_P1", "L_P_AGV_I_P2", "L_P_AGV_O_P2", "L_P_AGV_O_P1"});
  rows.push_back({.name = "L_P_TANK_I_LEVEL", .type = "INT", .initial = "0"});
  const BenchTables tables(reported, rows);
  const trace::PlantNames names(tables.rows);
  std::string json = "{";
  panel::put_plant(json, names, {}, {}, panel::Role::trainer);
  CHECK(Json::parse(json + "}").at("symbols").at(tables.symbol("TANK_I_LEVEL")).at("driver") == "signal");
}

TEST_CASE("The stream has the numbers of values that changed, and only those") {
  const PanelBench bench(plan_with_values());
  Stream stream(bench);
  CHECK(stream.next().at("values") == Json::parse("[[4.0,0],[20.0,0],[40.0,0],[3.0,0]]"));
  bench.act(R"({"state":{"L_P_AGV":"P2"}})");
  double load = 20;
  for (int seen = 0; seen < 5;) {
    const Json event = stream.next();
    if (!event.contains("values")) continue;
    for (const Json& entry : event.at("values")) {
      CHECK((entry.at(0) == kLoad || entry.at(0) == kDouble));
      if (entry.at(0) != kLoad) continue;
      CHECK(entry.at(1).get<double>() > load);
      load = entry.at(1);
      ++seen;
    }
  }
}

TEST_CASE("Values are in a picture without a stream, too") {
  const PanelBench bench(plan_with_values());
  bench.act(R"({"state":{"L_P_AGV":"P2"}})");
  bench.wait_for([&] { return number(bench, kDouble) > 41; });
  const Json values = bench.picture().at("values");
  CHECK(values.at(kDouble).at(0).get<double>() == 2 * values.at(kLoad).at(0).get<double>());
}

TEST_CASE("A parameter, an integral and a ramp are set within their limits, by acts that are logged and traced") {
  PanelBench bench(plan_with_values());
  const Stream stream(bench);
  bench.act(R"({"set":{"wind":12.5}},{"set":{"L_P_AGV.load":5000,"still":-1}})");
  bench.wait_for([&] { return number(bench, kWind) == 12.5 && number(bench, kLoad) == 1000; });
  const Json acts = bench.picture().at("acts");
  CHECK(acts.at(0).at("act") == Json::parse(R"({"set":{"wind":12.5}})"));
  CHECK(acts.at(1).at("act") == Json::parse(R"({"set":{"L_P_AGV.load":5000.0,"still":-1.0}})"));
  const HttpAnswer scenario = bench.send(bench.request("GET", "/api/v1/session/scenario"));
  CHECK(contains(scenario.body, R"("set":{"wind":12.5})"));
  bench.end();
  CHECK(contains(read_bytes(bench.folder / "trace.jsonl"), R"("act":{"set":{"wind":12.5}})"));
}

TEST_CASE("The number that was set last is seen in a frozen plant, too") {
  const PanelBench bench(plan_with_values());
  bench.act(R"({"freeze":true})");
  bench.act(R"({"set":{"wind":6}})");
  bench.act(R"({"set":{"wind":7}})");  // after the copy that shows 6
  bench.wait_for([&] { return number(bench, kWind) == 7; });
}

TEST_CASE("Acts that cannot set a value are refused with the reason") {
  const PanelBench bench(plan_with_values());
  const auto refused = [&](const std::string& act, const std::string& why) {
    const HttpAnswer answer = bench.post(act);
    CHECK(answer.status == 422);
    INFO(answer.body);
    CHECK(contains(answer.body, why));
  };
  refused(R"({"set":{"double":1}})", "is computed from others and cannot be set");
  refused(R"({"set":{"wind":true}})", "is a value; write a number");
  refused(R"({"force":{"wind":1}})", "wind");
}

TEST_CASE("A malfunction that holds a parameter is in the description, and marks it while it is active") {
  const PanelBench bench(plan_with_values(R"("malfunctions":[{"name":"storm","set":{"wind":25}}])"));
  CHECK(bench.get("/api/v1/plant").at("malfunctions").at(0).at("values") == Json::array({kWind}));
  const Stream stream(bench);
  bench.act(R"({"start":"storm"})");
  bench.wait_for([&] { return bench.picture().at("values").at(kWind) == Json::parse("[25.0,1]"); });
  CHECK(bench.picture().at("values").at(kLoad).at(1) == 0);
  bench.act(R"({"set":{"wind":9}})");
  bench.act(R"({"stop":"storm"})");
  bench.wait_for([&] { return bench.picture().at("values").at(kWind) == Json::parse("[9.0,0]"); });
}

TEST_CASE("A reset sets all values back at once") {
  const PanelBench bench(plan_with_values(R"("malfunctions":[{"name":"storm","set":{"wind":25}}])"));
  const Stream stream(bench);
  bench.act(R"({"set":{"L_P_AGV.load":500},"start":"storm"})");
  bench.wait_for([&] { return number(bench, kLoad) == 500; });
  bench.act(R"({"reset":true})");
  const Json values = bench.picture().at("values");
  CHECK(values.at(kWind) == Json::parse("[4.0,0]"));
  CHECK(values.at(kLoad) == Json::parse("[20.0,0]"));
}

TEST_CASE("A chart of values has the number at its start and each change that a trace shows, and goes on") {
  const PanelBench bench(plan_with_values());
  bench.act(R"({"state":{"L_P_AGV":"P2"}})");
  bench.wait_for([&] { return bench.picture().at("t") > 300 * kMs; });
  bench.act(R"({"freeze":true})");
  Json chart = bench.get("/api/v1/chart?values=0,1,2&devices=0&from=0");
  const Json load = chart.at("values").at(kLoad);
  REQUIRE(load.size() > 5);
  CHECK(load.at(0) == Json::parse("[0,20.0]"));
  for (const Json& entry : load) CHECK(entry.at(0).get<tables::Time>() % (20 * kMs) == 0);
  CHECK(chart.at("values").at(kWind).size() <= 2);
  CHECK(chart.at("values").at(kDouble).empty());  // no trace shows it
  CHECK(chart.at("devices").at(0).size() > 1);
  const std::string after = "&after=" + std::to_string(chart.at("next").get<std::uint64_t>()) +
                            "&after_value=" + std::to_string(chart.at("next_value").get<std::uint64_t>());
  CHECK(bench.get("/api/v1/chart?values=1" + after).at("values").at(0).empty());
  const tables::Time last = load.back().at(0);
  chart = bench.get("/api/v1/chart?values=1&from=" + std::to_string(last + 1));
  CHECK(chart.at("values").at(0) == Json::array({Json::array({last + 1, load.back().at(1)})}));
  CHECK_FALSE(bench.get("/api/v1/chart?symbols=0&from=0").contains("values"));
  CHECK(bench.send(bench.request("GET", "/api/v1/chart?values=4&from=0")).status == 400);
  bench.act(R"({"run":true})");
  bench.wait_for([&] { return !bench.get("/api/v1/chart?values=1" + after).at("values").at(0).empty(); });
}

TEST_CASE("The panel explains a value, and names the nearest one") {
  const PanelBench bench(plan_with_values());
  CHECK(bench.why("L_P_AGV.load") == "L_P_AGV.load is 20 l: integral of wind (4) * L_P_AGV.P2 (0)\n");
  const HttpAnswer answer = bench.send(bench.request("GET", "/api/v1/why?name=wint"));
  CHECK(contains(answer.body, "did you mean `wind`?"));
}

TEST_CASE("A recording shows the values of its trace") {
  const BenchTables tables({"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1"}, with_values());
  const trace::PlantNames names(tables.rows);
  std::istringstream file(R"({"symplant-trace":1,"plant":"p","model_hash":"00000000000000aa","seed":0}
{"t":0,"value":"wind","is":4}
{"t":100000000,"value":"wind","is":5.5}
)");
  panel::Recording recording(trace::read_trace(file, names), names, {}, 0xAA);
  const auto wind = [&](tables::Time time) { return Json::parse(recording.picture_at(time)).at("values").at(kWind); };
  CHECK(wind(50 * kMs) == Json::parse("[4.0,0]"));
  CHECK(wind(100 * kMs) == Json::parse("[5.5,0]"));
  CHECK(wind(50 * kMs) == Json::parse("[4.0,0]"));
  const auto read = [&](const std::string& line) {
    std::istringstream bad("{\"symplant-trace\":1,\"plant\":\"p\",\"model_hash\":\"00000000000000aa\",\"seed\":0}\n" +
                           line + "\n");
    return trace::read_trace(bad, names);
  };
  CHECK(read(R"({"t":0,"value":"other","is":4})").first_unknown == "other");
  CHECK(contains(read(R"({"t":0,"value":"wind","is":true})").error, "a value has a name and a number `is`"));
}

TEST_CASE("The outputs of values are copied only if the panel asks") {
  const BenchTables tables({"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1"}, with_values());
  plant::OwnedPlant plant(tables.rows);
  plant.reset();
  panel::OutputCopy copy(plant);
  REQUIRE(copy.is_here());
  CHECK(copy.numbers()[kWind] == 4);
  plant.set_value(kWind, 6);
  copy.give(plant);
  CHECK(copy.numbers()[kWind] == 4);
  copy.ask();
  CHECK_FALSE(copy.is_here());
  copy.give(plant);
  REQUIRE(copy.is_here());
  CHECK(copy.numbers()[kWind] == 6);
}

}  // namespace
}  // namespace symplant::test

// A trace in the panel: reading it back, and what is reconstructed of it.
#include "symplant/panel/recording/recording.hpp"

#include <sstream>

#include "symplant/panel/recording/reconstruct.hpp"
#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

const std::string kHead = R"({"symplant-trace":1,"plant":"p","model_hash":"00000000000000aa","seed":0})"
                          "\n";

struct Belt {
  Belt() : Belt(reported(), {}) {}
  Belt(const Reported& described, std::vector<std::string> further)
      : tables(names(std::move(further)), described), plant_names(tables.rows) {}
  static std::vector<std::string> names(std::vector<std::string> further) {
    further.insert(further.begin(), {"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1"});
    return further;
  }
  static Reported reported() {
    Reported reported;
    description::GivenMaterial& material = reported.description.material;
    material.kinds.push_back({"raw", 100'000, 1});
    description::GivenTrack track;
    track.name = "BELT";
    track.length = 1'000'000;
    description::GivenDrive drive;
    drive.forward = "L_P_AGV.P2";
    drive.speed.speed = 500'000;
    track.drives.push_back(drive);
    material.tracks.push_back(track);
    description::GivenPlace place;
    place.name = "BOX";
    place.holds = 5;
    material.places.push_back(place);
    return reported;
  }
  trace::ReadTrace read(const std::string& lines) const {
    std::istringstream file(lines);
    return trace::read_trace(file, plant_names);
  }
  panel::Recording recording(const std::string& lines) const { return {read(lines), plant_names, {}, 0xAA}; }

  BenchTables tables;
  trace::PlantNames plant_names;
};

TEST_CASE("The state of a device follows from its events, and the time of its move from its arrival") {
  const Belt belt;
  panel::Recording recording = belt.recording(kHead +
                                              R"({"t":0,"symbol":"L_P_AGV_I_P1","value":true}
{"t":1000000,"symbol":"L_P_AGV_O_P2","value":true}
{"t":1000000,"symbol":"L_P_AGV_I_P1","value":false}
{"t":5000000,"symbol":"L_P_AGV_I_P2","value":true}
)");
  const auto device = [&](tables::Time time) { return Json::parse(recording.picture_at(time)).at("devices").at(0); };
  CHECK(device(0) == Json::parse("[0,0,0,0,0,0,0]"));
  CHECK(device(2'000'000) == Json::parse("[0,1,1,0,1000000,3000000,4000000]"));
  CHECK(device(5'000'000) == Json::parse("[1,1,0,0,5000000,0,0]"));
  CHECK(device(500) == Json::parse("[0,0,0,0,0,0,0]"));  // back again
  CHECK(device(4'000'000) == Json::parse("[0,1,1,0,1000000,1000000,4000000]"));
}

TEST_CASE("A part moves evenly from where it came to the end of its track") {
  const Belt belt;
  panel::Recording recording = belt.recording(kHead + R"({"t":0,"part":1,"kind":"raw","to":"BELT","x":100000}
{"t":1000000000,"part":1,"kind":"raw","from":"BELT","to":"BOX"}
)");
  const Json begun = Json::parse(recording.picture_at(0));
  CHECK(begun.at("tracks").at(0) == Json::parse("[0,[[1,0,100000,900000]],[],[0]]"));
  const Json over = Json::parse(recording.picture_at(1'000'000'000));
  CHECK(over.at("tracks").at(0).at(1).empty());
  CHECK(over.at("places").at(0) == Json::parse("[[1,0]]"));
}

TEST_CASE("A part is where a sensor begins or ends to see it") {
  Reported reported = Belt::reported();
  description::GivenSensor sensor;
  sensor.symbol = "L_P_EYE_I_ON";
  sensor.at = 600'000;
  reported.description.material.tracks.front().sensors.push_back(sensor);
  const Belt belt(reported, {"EYE_I_ON"});
  panel::Recording recording = belt.recording(kHead + R"({"t":0,"part":1,"kind":"raw","to":"BELT","x":100000}
{"t":1000000000,"symbol":"L_P_EYE_I_ON","value":true}
{"t":2000000000,"part":2,"kind":"raw","to":"BELT","x":100000}
{"t":9000000000,"symbol":"L_P_EYE_I_ON","value":false}
{"t":10000000000,"part":1,"kind":"raw","from":"BELT","to":"BOX"}
)");
  const auto parts = [&](tables::Time seconds) {
    return Json::parse(recording.picture_at(seconds * 1'000'000'000)).at("tracks").at(0).at(1);
  };
  CHECK(parts(0) == Json::parse("[[1,0,100000,500000]]"));
  CHECK(parts(1) == Json::parse("[[1,0,600000,12500]]"));  // a stop held it
  CHECK(parts(9) == Json::parse("[[1,0,700000,300000],[2,0,100000,0]]"));
  CHECK(parts(10) == Json::parse("[[2,0,100000,0]]"));
}

TEST_CASE("A part that took longer than its drive needs waited at the stop on its path") {
  Reported reported = Belt::reported();
  description::GivenStop stop;
  stop.at = 600'000;
  stop.when = "L_P_AGV.P1";
  reported.description.material.tracks.front().stops.push_back(stop);
  const Belt belt(reported, {});
  panel::Recording recording = belt.recording(kHead + R"({"t":0,"part":1,"kind":"raw","to":"BELT","x":100000}
{"t":10000000000,"part":1,"kind":"raw","from":"BELT","to":"BOX"}
)");
  const auto front = [&](double seconds) {
    const Json track = Json::parse(recording.picture_at(static_cast<tables::Time>(seconds * 1e9))).at("tracks").at(0);
    const auto t = track.at(0).get<tables::Time>();
    const Json part = track.at(1).at(0);
    const double passed = seconds - static_cast<double>(t) / 1e9;
    return part.at(2).get<double>() + part.at(3).get<double>() * passed;
  };
  CHECK(front(0.5) == Catch::Approx(350'000));  // the drive moves 0.5 m/s
  CHECK(front(1.5) == Catch::Approx(600'000));
  CHECK(front(9) == Catch::Approx(600'000));
  CHECK(front(9.6) == Catch::Approx(800'000));
}

TEST_CASE("Of a plant that was set back, the trace after the last time is shown") {
  const Belt belt;
  const trace::ReadTrace read = belt.read(kHead + R"({"t":5000,"symbol":"L_P_AGV_I_P1","value":true}
{"t":1000,"restored":"a","values":{"L_P_AGV_I_P2":true}}
{"t":2000,"act":{"run":true},"by":"hand"}
{"t":3000,"symbol":"L_P_AGV_O_P1","value":true}
)");
  CHECK(read.error == "");
  CHECK(read.set_back == 1);
  CHECK(read.begin == 1000);
  CHECK(read.end == 3000);
  REQUIRE(read.records.size() == 2);
  CHECK(read.records[0].of == belt.tables.symbol("AGV_I_P2"));
}

TEST_CASE("A line that is not one of a trace is named") {
  const Belt belt;
  for (const auto& [lines, error] : std::vector<std::pair<std::string, std::string>>{
           {"", "line 1: the file is empty"},
           {"{}\n", "line 1: a trace begins with"},
           {"x\n", "line 1: this is not a line"},
           {kHead + "[]\n", "line 2: this is not a line"},
           {kHead + "{\"symbol\":\"L_P_AGV_I_P1\",\"value\":true}\n", "line 2: the key `t`"},
           {kHead + "{\"t\":5,\"symbol\":\"L_P_AGV_I_P1\",\"value\":3}\n", "cannot have the value 3"},
           {kHead + "{\"t\":5,\"symbol\":\"L_P_AGV_I_P1\"}\n", "line 2: a change has"},
           {kHead + "{\"t\":5,\"x\":1}\n{\"t\":4,\"x\":1}\n", "line 3: this time is before"},
           {"{\"symplant-trace\":2}\n", "version 1"},
       }) {
    INFO(lines);
    CHECK(contains(belt.read(lines).error, error));
  }
  const trace::ReadTrace other = belt.read(kHead + "{\"t\":5,\"symbol\":\"X\",\"value\":true}\n");
  CHECK(other.error == "");
  CHECK(other.unknown == 1);
  CHECK(other.first_unknown == "X");
}

TEST_CASE("What a recorder of motions has seen, and what is reconstructed of its trace, are the same states") {
  PanelPlan plan;
  PanelBench bench(plan);
  bench.act(R"({"set":{"L_P_AGV_O_P2":true}})");
  bench.wait_for([&] { return bench.value("AGV_I_P2") == true; });
  bench.act(R"({"set":{"L_P_AGV_O_P2":false,"L_P_AGV_O_P1":true}})");
  const Json live = bench.device("AGV");
  const tables::Time at = bench.act(R"({"freeze":true})");
  bench.end();
  std::ifstream file(bench.folder / "trace.jsonl");
  trace::ReadTrace read = trace::read_trace(file, bench.names);
  CHECK(read.error == "");
  panel::Recording recording(std::move(read), bench.names, {}, 0);
  const Json shown = Json::parse(recording.picture_at(at)).at("devices").at(bench.tables.unit_index("AGV"));
  for (const std::size_t i : {0U, 1U, 2U, 4U}) CHECK(shown.at(i) == live.at(i));
}

}  // namespace
}  // namespace symplant::test

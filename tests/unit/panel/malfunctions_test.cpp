// Malfunctions in the panel: what clients see of them, start and stop, and what a trace shows.
#include <fstream>

#include "support/malfunction_bench.hpp"
#include "symplant/panel/recording/recording.hpp"
#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

PanelPlan faulty() {
  PanelPlan plan;
  plan.reported = with_malfunctions(R"({"name":"jam","of":"L_P_AGV","stuck":true},
                                       {"name":"eye blind","force":{"L_P_EYE_I_ON":true}},
                                       {"name":"contact","flicker":{"symbol":"L_P_DOOR_I_SHUT1","every":"1 h","for":"1s"}})");
  return plan;
}

Json names_of(const Json& picture) {
  Json names = Json::array();
  for (const Json& one : picture.at("malfunctions")) names.push_back(one.at(0));
  return names;
}

TEST_CASE("The description has the malfunctions with what they act on, and the kinds of the ordinary ones") {
  const PanelBench bench(faulty());
  const Json plant = bench.get("/api/v1/plant");
  const auto symbol = [&](const std::string& name) { return Json::array({bench.tables.symbol(name)}); };
  const Json none = Json::array();
  CHECK(plant.at("malfunctions") ==
        Json({{{"name", "jam"},
               {"kind", "stuck"},
               {"devices", Json::array({bench.tables.unit_index("AGV")})},
               {"symbols", none}},
              {{"name", "eye blind"}, {"kind", "force"}, {"devices", none}, {"symbols", symbol("EYE_I_ON")}},
              {{"name", "contact"}, {"kind", "flicker"}, {"devices", none}, {"symbols", symbol("DOOR_I_SHUT1")}}}));
  CHECK(plant.at("ordinary") == Json::parse(R"({"device":["stuck","slow"],"event":["stuck on","stuck off"]})"));
}

TEST_CASE("Malfunctions are started and stopped by name, and mark what they act on") {
  const PanelBench bench(faulty());
  const tables::Time at = bench.act(R"({"start":["jam","eye blind"]})");
  const Json picture = bench.picture();
  CHECK(picture.at("malfunctions") ==
        Json::array({Json::array({"jam", at, "hand"}), Json::array({"eye blind", at, "hand"})}));
  CHECK((bench.device("AGV").at(2).get<unsigned>() & 16U) == 16U);
  CHECK((bench.device("AGV").at(2).get<unsigned>() & 4U) == 4U);
  CHECK((bench.device("DOOR").at(2).get<unsigned>() & 16U) == 0U);
  const Json eye = picture.at("symbols").at(bench.tables.symbol("EYE_I_ON"));
  CHECK(eye.at(0) == true);
  CHECK(eye.at(1) == 2);
  bench.act(R"({"stop":"eye blind"},{"stop":"jam"})");
  CHECK(names_of(bench.picture()).empty());
  CHECK(bench.device("AGV").at(2) == 0);
  CHECK(bench.picture().at("symbols").at(bench.tables.symbol("EYE_I_ON")).at(1) == 0);
}

TEST_CASE("Ordinary malfunctions are marked like described ones, and the mark stays until the last one ends") {
  const PanelBench bench(faulty());
  const auto flags = [&] { return bench.picture().at("symbols").at(bench.tables.symbol("EYE_I_ON")).at(1); };
  bench.act(R"({"start":["L_P_EYE_I_ON stuck off","eye blind","L_P_DOOR slow"]})");
  CHECK(flags() == 2);
  CHECK(bench.device("DOOR").at(2) == 16);
  bench.act(R"({"stop":"eye blind"})");
  CHECK(flags() == 2);
  CHECK(bench.value("EYE_I_ON") == false);
  bench.act(R"({"force":{"L_P_EYE_I_ON":true}})");
  CHECK(flags() == 3);
  CHECK(bench.value("EYE_I_ON") == true);
  bench.act(R"({"stop":"L_P_EYE_I_ON stuck off"})");
  CHECK(flags() == 1);
}

TEST_CASE("An unknown malfunction is refused with the nearest name, and too many ordinary ones fail") {
  PanelPlan plan = faulty();
  std::string all;
  for (int i = 0; i < 65; ++i) {
    plan.names.push_back("PE" + std::to_string(i) + "_I_ON");
    all += (all.empty() ? "" : ",") + ("\"L_P_" + plan.names.back() + " stuck on\"");
  }
  const PanelBench bench(plan);
  const HttpAnswer unknown = bench.post(R"({"start":"jamm"})");
  CHECK(unknown.status == 422);
  CHECK(contains(unknown.body, "did you mean `jam`?"));
  const HttpAnswer many = bench.post("{\"start\":[" + all + "]}");
  INFO(many.body);
  CHECK(many.status == 422);
  CHECK(contains(many.body, "malfunction"));
  CHECK(names_of(bench.picture()).size() == 64);
}

TEST_CASE("A request changes at most as many parts and malfunctions as one instant reports") {
  const PanelBench bench(faulty());
  std::string acts;
  for (int i = 0; i < 90; ++i) {
    acts +=
        (acts.empty() ? "" : ",") +
        std::string(R"({"start":["jam","jam","jam","jam","jam","jam"],"stop":["jam","jam","jam","jam","jam","jam"]})");
  }
  const HttpAnswer many = bench.post(acts);
  CHECK(many.status == 400);
  CHECK(contains(many.body, "1080 parts and malfunctions; at most 1024"));
}

TEST_CASE("A reset ends malfunctions, and a snapshot brings them back") {
  const PanelBench bench(faulty());
  bench.act(R"({"freeze":true})");
  const tables::Time at = bench.act(R"({"start":"jam"})");
  bench.act(R"({"snapshot":"jammed"})");
  bench.act(R"({"reset":true})");
  CHECK(names_of(bench.picture()).empty());
  CHECK(bench.device("AGV").at(2) == 0);
  bench.act(R"({"restore":"jammed"})");
  CHECK(bench.picture().at("malfunctions") == Json::array({Json::array({"jam", at, "hand"})}));
  CHECK((bench.device("AGV").at(2).get<unsigned>() & 16U) == 16U);
}

TEST_CASE("The explanation of a device names the malfunction that disables it") {
  const PanelBench bench(faulty());
  bench.act(R"({"set":{"L_P_AGV_O_P2":true},"start":"jam"})");
  const Json why = bench.get("/api/v1/why?name=L_P_AGV");
  CHECK(contains(why.dump(), "disabled by malfunction `jam`"));
}

TEST_CASE("A trace brings malfunctions back, also those that were active when the plant was set to a state") {
  PanelBench bench(faulty());
  bench.act(R"({"freeze":true})");
  bench.act(R"({"start":["jam","L_P_EYE_I_ON stuck on","L_P_DOOR slow"]})");
  bench.act(R"({"snapshot":"a"})");
  bench.act(R"({"stop":["jam","L_P_DOOR slow"]})");
  const auto shown = [&](const char* which) {
    std::ifstream file(bench.folder / "trace.jsonl");
    trace::ReadTrace read = trace::read_trace(file, bench.names);
    INFO(which);
    CHECK(read.error == "");
    CHECK(read.unknown == 0);
    const tables::Time end = read.end;
    return Json::parse(panel::Recording(std::move(read), bench.names, {}, 0).picture_at(end));
  };
  bench.act(R"({"restore":"a"},{"stop":"jam"})");
  bench.end();
  const Json picture = shown("after the restore");
  CHECK(names_of(picture) == Json::array({"L_P_EYE_I_ON stuck on", "L_P_DOOR slow"}));
  CHECK(picture.at("malfunctions").at(0).at(2) == "hand");
  CHECK((picture.at("devices").at(bench.tables.unit_index("DOOR")).at(2).get<unsigned>() & 16U) == 16U);
}

TEST_CASE("Lines of a trace about malfunctions are checked like others") {
  const BenchTables tables(faulty().names, faulty().reported);
  const trace::PlantNames names(tables.rows);
  const auto read = [&](const std::string& line) {
    std::istringstream file("{\"symplant-trace\":1}\n" + line + "\n");
    return trace::read_trace(file, names);
  };
  CHECK(
      contains(read(R"({"t":1,"malfunction":3,"active":true,"by":"hand"})").error, "line 2: a malfunction has a name"));
  CHECK(contains(read(R"({"t":1,"malfunction":"jam","by":"hand"})").error, "line 2: a malfunction has a name"));
  CHECK(
      contains(read(R"({"t":1,"malfunction":"jam","active":true,"by":"me"})").error, "malfunction `jam` has no `by`"));
  CHECK(
      contains(read(R"({"t":1,"reset":"","malfunctions":["jam"]})").error, "`malfunctions` is not an array of pairs"));
  CHECK(read(R"({"t":1,"malfunction":"L_P_AGV_O_P1 stuck on","active":true,"by":"hand"})").first_unknown ==
        "L_P_AGV_O_P1 stuck on");
}

}  // namespace
}  // namespace symplant::test

// What clients of the panel do to a plant.
#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

TEST_CASE("Operations are written, and the picture shows the move") {
  const PanelBench bench;
  const tables::Time begun = bench.act(R"({"set":{"L_P_AGV_O_P2":true}})");
  const Json moving = bench.device("AGV");
  CHECK(moving.at(0) == 0);
  CHECK(moving.at(1) == 1);
  CHECK(moving.at(2) == 1);
  CHECK(moving.at(4) == begun);
  CHECK(moving.at(6) == 1'000'000'000);
  bench.wait_for([&] { return bench.device("AGV").at(0) == 1; });
  CHECK(bench.value("AGV_I_P2") == true);
  CHECK(bench.value("AGV_I_P1") == false);
}

TEST_CASE("A device that has a command and does not move is shown so") {
  PanelPlan plan;
  plan.reported.disables("DOOR", "OPEN2", "AGV");
  const PanelBench bench(plan);
  bench.act(R"({"state":{"L_P_DOOR":"OPEN2"}},{"set":{"L_P_AGV_O_P2":true}})");
  const Json agv = bench.device("AGV");
  CHECK(agv.at(2) == 4);
  CHECK(agv.at(3) == 1);
  CHECK(bench.device("DOOR").at(0) == 1);
}

TEST_CASE("Several acts of one request take effect in one instant") {
  const PanelBench bench;
  bench.act(R"({"force":{"L_P_AGV_I_P1":false}},{"release":["L_P_AGV_I_P1"]})");
  CHECK(bench.value("AGV_I_P1") == true);
  const Json symbol = bench.picture().at("symbols").at(bench.tables.symbol("AGV_I_P1"));
  CHECK(symbol.at(2) == 0);  // it did not change
}

TEST_CASE("Forces hold until they are released, one or all") {
  const PanelBench bench;
  bench.act(R"({"force":{"L_P_AGV_I_P2":true,"L_P_AGV_I_P1":false,"L_P_AGV_O_P1":true}})");
  const Json forced = bench.picture().at("symbols");
  CHECK(forced.at(bench.tables.symbol("AGV_I_P2")).at(0) == true);
  CHECK(forced.at(bench.tables.symbol("AGV_I_P2")).at(1) == 1);
  bench.act(R"({"release":["L_P_AGV_I_P2"]})");
  CHECK(bench.picture().at("symbols").at(bench.tables.symbol("AGV_I_P2")).at(1) == 0);
  CHECK(bench.value("AGV_I_P2") == false);
  bench.act(R"({"release":"all"})");
  const Json symbols = bench.picture().at("symbols");
  for (const Json& symbol : symbols) CHECK(symbol.at(1) == 0);
  CHECK(bench.value("AGV_I_P1") == true);
}

TEST_CASE("A frozen plant does not move, does acts, and goes on") {
  const PanelBench bench;
  bench.act(R"({"set":{"L_P_AGV_O_P2":true}},{"freeze":true})");
  const tables::Time at = bench.picture().at("t");
  CHECK(bench.picture().at("clock").at("state") == "frozen");
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  CHECK(bench.picture().at("t") == at);
  CHECK(bench.act(R"({"force":{"L_P_AGV_I_P2":true}})") == at);
  CHECK(bench.value("AGV_I_P2") == true);
  bench.act(R"({"run":true})");
  bench.wait_for([&] { return bench.picture().at("t") > at; });
}

TEST_CASE("A frozen plant is stepped by a cycle, and to the next change") {
  const PanelBench bench;
  bench.act(R"({"freeze":true})");
  bench.act(R"({"set":{"L_P_AGV_O_P2":true}})");
  const tables::Time at = bench.picture().at("t");
  const auto frozen_after = [&](const std::string& step) {
    bench.act(step);
    bench.wait_for([&] { return bench.picture().at("clock").at("state") == "frozen"; });
    return bench.picture().at("t").get<tables::Time>();
  };
  const tables::Time stepped = frozen_after(R"({"step":"cycle"})");
  CHECK(stepped == at + kMs);
  const tables::Time changed = frozen_after(R"({"step":"change"})");
  CHECK(changed >= at + 1000 * kMs);
  CHECK(changed <= at + 1001 * kMs);
  CHECK(bench.value("AGV_I_P2") == true);
}

TEST_CASE("A part taken and another one put in one request is a part that changes its kind") {
  const PanelBench bench(with_fixture());
  bench.act(R"({"put":{"at":"FIXTURE","kind":"raw"}})");
  bench.act(R"({"take":"FIXTURE"},{"put":{"at":"FIXTURE","kind":"machined"}})");
  CHECK(bench.picture().at("places").at(0) == Json::parse("[[2,1]]"));
}

TEST_CASE("Parts without room, and parts that are not there, fail and are said") {
  const PanelBench bench(with_fixture());
  const HttpAnswer none = bench.post(R"({"take":"FIXTURE"})");
  CHECK(none.status == 422);
  CHECK(contains(none.body, "there is no part there; the other acts were done"));
  bench.act(R"({"put":{"at":"FIXTURE","kind":"raw"}})");
  CHECK(bench.picture().at("places").at(0) == Json::parse("[[1,0]]"));
  const HttpAnswer full = bench.post(R"({"put":{"at":"FIXTURE","kind":"raw"}})");
  CHECK(full.status == 422);
  CHECK(contains(full.body, "a part has no room there; the other acts were done"));
  bench.act(R"({"take":"FIXTURE"})");
  CHECK(bench.picture().at("places").at(0).empty());
}

TEST_CASE("A reset begins again at time 0") {
  const PanelBench bench;
  bench.act(R"({"set":{"L_P_AGV_O_P2":true},"force":{"L_P_EYE_I_ON":true}})");
  bench.wait_for([&] { return bench.value("AGV_I_P2") == true; });
  bench.act(R"({"freeze":true})");
  bench.act(R"({"reset":true})");
  const Json picture = bench.picture();
  CHECK(picture.at("t") == 0);
  CHECK(bench.value("AGV_I_P1") == true);
  CHECK(bench.value("AGV_I_P2") == false);
  CHECK(bench.value("AGV_O_P2") == false);
  CHECK(bench.value("EYE_I_ON") == false);
  CHECK(picture.at("clock").at("state") == "frozen");
}

TEST_CASE("After a reset nothing has a time of the run before, and its findings are gone") {
  PanelPlan plan;
  plan.reported.description.requirements.push_back({"never in P2", "L_P_AGV.P2", "", "", 0, ""});
  const PanelBench bench(plan);
  bench.act(R"({"set":{"L_P_AGV_O_P2":true}})");
  bench.wait_for([&] { return bench.value("AGV_I_P2") == true; });
  bench.act(R"({"set":{"L_P_EYE_I_ON":true}})");
  bench.act(R"({"set":{"L_P_EYE_I_ON":false,"L_P_AGV_O_P2":false}})");  // as they are after a reset
  bench.act(R"({"freeze":true})");
  const Json before = bench.picture();
  CHECK(before.at("symbols").at(bench.tables.symbol("EYE_I_ON")).at(2) > 0);
  CHECK(before.at("findings").size() == 1);
  CHECK(before.at("requirements").at(0).at(0) == "violated");
  bench.act(R"({"reset":true})");
  const Json after = bench.picture();
  for (const Json& symbol : after.at("symbols")) CHECK(symbol.at(2) == 0);
  for (const Json& device : after.at("devices")) CHECK(device.at(4) == 0);
  CHECK(after.at("findings").empty());
  CHECK(after.at("requirements").at(0) == Json::parse(R"(["ok",0,0])"));
  const std::string why = bench.get("/api/v1/why?name=L_P_AGV").dump();
  CHECK_FALSE(contains(why, "was on from"));
}

TEST_CASE("A snapshot brings the plant back to its state and time") {
  const PanelBench bench;
  bench.act(R"({"freeze":true})");
  bench.act(R"({"set":{"L_P_AGV_O_P2":true},"force":{"L_P_EYE_I_ON":true}})");
  bench.act(R"({"snapshot":"in the move"})");
  const Json before = bench.picture();
  bench.act(R"({"run":true})");
  bench.wait_for([&] { return bench.value("AGV_I_P2") == true; });
  bench.act(R"({"release":"all"},{"set":{"L_P_AGV_O_P2":false}},{"freeze":true})");
  bench.act(R"({"restore":"in the move"})");
  const Json after = bench.picture();
  CHECK(after.at("t") == before.at("t"));
  CHECK(after.at("devices").at(0) != bench.device("DOOR"));
  CHECK(after.at("devices").at(0).at(5) == before.at("devices").at(0).at(5));  // the time left of the move
  CHECK(after.at("symbols").at(bench.tables.symbol("EYE_I_ON")).at(1) == 1);
  bench.act(R"({"run":true})");
  bench.wait_for([&] { return bench.value("AGV_I_P2") == true; });
}

TEST_CASE("Snapshots are listed, forgotten, and written to files that another run reads") {
  PanelPlan plan;
  const TemporaryFolder files;
  plan.options.files = files.path();
  tables::Time at = 0;
  {
    const PanelBench bench(plan);
    bench.act(R"({"freeze":true},{"snapshot":"a"},{"snapshot":"b"})");
    at = bench.act(R"({"save":"kept"})");
    CHECK(bench.picture().at("snapshots").size() == 3);
    bench.act(R"({"forget":"a"})");
    CHECK(bench.post(R"({"restore":"a"})").status == 422);
    CHECK(bench.post(R"({"forget":"a"})").status == 422);
    CHECK(bench.picture().at("snapshots").at(0).at("name") == "b");
  }
  {
    const PanelBench bench(plan);
    CHECK(bench.picture().at("snapshots").at(0).at("name") == "kept");
    CHECK(bench.act(R"({"freeze":true},{"restore":"kept"})") == at);
  }
  plan.names.emplace_back("LAMP_O_ON");
  const PanelBench bench(plan);
  const HttpAnswer other = bench.post(R"({"restore":"kept"})");
  CHECK(other.status == 422);
  CHECK(contains(other.body, "another model"));
}

TEST_CASE("A snapshot that the same request forgets is not restored") {
  const PanelBench bench;
  bench.act(R"({"freeze":true},{"snapshot":"a"})");
  const HttpAnswer answer = bench.post(R"({"forget":"a"},{"restore":"a"})");
  CHECK(answer.status == 422);
  CHECK(contains(answer.body, "there is no snapshot `a`"));
  bench.act(R"({"snapshot":"b"})");
  CHECK(bench.act(R"({"restore":"b"})") >= 0);
}

TEST_CASE("A state is kept each time the backtrack has passed, and the last thirty of them") {
  PanelPlan plan;
  plan.options.backtrack = 20 * kMs;
  const PanelBench bench(plan);
  bench.wait_for([&] { return bench.picture().at("snapshots").size() >= 2; });
  const Json backtrack = bench.picture().at("snapshots").at(0);
  CHECK(backtrack.at("kind") == "backtrack");
  bench.act(R"({"freeze":true},{"restore":")" + backtrack.at("name").get<std::string>() + "\"}");
  CHECK(bench.picture().at("t") == backtrack.at("t"));
}

TEST_CASE("What is not possible is refused before anything is done") {
  const PanelBench bench;
  for (const auto& [act, words] : std::vector<std::pair<std::string, std::string>>{
           {R"({"restore":"none"})", "no snapshot `none`"},
           {R"({"save":"a"})", "--panel-files"},
           {R"({"session":"a"})", "--panel-files"},
           {R"({"exercise":"none"})", "--exercise"},
           {R"({"speed":0})", "from 0.1 to 100"},
           {R"({"speed":"fast"})", "from 0.1 to 100"},
           {R"({"step":"two"})", "not one of its values"},
           {R"({"set":{"L_P_AGV_I_P1":true}})", "`state`"},
           {R"({"force":{"L_P_AGV_I_P1":1}})", "true"},
           {R"({"plus":"1s","force":{"L_P_AGV_I_P1":true}})", "`plus` is not an act"},
           {R"({"expect":"L_P_AGV.P1"})", "not an act"},
           {R"({})", "without keys"},
       }) {
    INFO(act);
    const HttpAnswer answer = bench.post(R"({"force":{"L_P_AGV_I_P2":true}},)" + act);
    CHECK(answer.status == 422);
    INFO(answer.body);
    CHECK(contains(answer.body, words));
    const HttpAnswer checked = bench.send(bench.request("POST", "/api/v1/check", "{\"acts\":[" + act + "]}"));
    CHECK(checked.status == 422);
  }
  CHECK(bench.value("AGV_I_P2") == false);
  for (const std::string body :
       {"", "[]", "{}", "{\"acts\":{}}", "{\"acts\":[]}", "{\"acts\":[1]}", "{\"acts\":[{}],\"x\":1}"}) {
    INFO(body);
    CHECK(bench.send(bench.request("POST", "/api/v1/acts", body)).status == 400);
  }
}

TEST_CASE("A key that is not known is an error of the form, with the nearest one, and nothing is done") {
  const PanelBench bench;
  for (const auto& [act, words] : std::vector<std::pair<std::string, std::string>>{
           {R"({"jump":true})", "`jump` is not the key of an act"},
           {R"({"forse":{"L_P_AGV_I_P1":true}})", "did you mean `force`?"},
           {R"({"Force":{"L_P_AGV_I_P1":true}})", "did you mean `force`?"},
           {R"({"restor":"a"})", "did you mean `restore`?"},
           {R"({"spede":2})", "did you mean `speed`?"},
           {R"({"":1})", "`` is not the key of an act"},
           {R"({"set":{"L_P_EYE_I_ON":true},"sett":{}})", "did you mean `set`?"},
       }) {
    INFO(act);
    for (const std::string path : {"/api/v1/acts", "/api/v1/check"}) {
      const HttpAnswer answer =
          bench.send(bench.request("POST", path, R"({"acts":[{"force":{"L_P_AGV_I_P2":true}},)" + act + "]}"));
      INFO(answer.body);
      CHECK(answer.status == 400);
      CHECK(contains(answer.body, words));
    }
  }
  const HttpAnswer body = bench.send(bench.request("POST", "/api/v1/acts", R"({"atcs":[{"freeze":true}]})"));
  CHECK(body.status == 400);
  CHECK(contains(body.body, "`atcs` is not a key of the body; did you mean `acts`?"));
  CHECK(bench.value("AGV_I_P2") == false);
}

TEST_CASE("A command is alone in its act") {
  const PanelBench bench;
  for (const std::string act :
       {R"({"restore":"/etc/passwd","force":{}})", R"({"force":{"L_P_AGV_I_P2":true},"restore":"a"})",
        R"({"run":true,"freeze":true})", R"({"speed":2,"reset":true})",
        R"({"step":"cycle","set":{"L_P_EYE_I_ON":true}})", R"({"snapshot":"a","text":"b"})",
        R"({"end":"exercise","exercise":"a"})", R"({"session":"a","plus":"1s"})"}) {
    INFO(act);
    const HttpAnswer answer = bench.post(act);
    CHECK(answer.status == 400);
    CHECK(contains(answer.body, "` is alone in an act"));
  }
  CHECK(bench.value("AGV_I_P2") == false);
  CHECK(bench.picture().at("clock").at("state") == "running");
}

TEST_CASE("An act that does nothing, or has a value of another type, is an error") {
  const PanelBench bench;
  for (const std::string act : {R"({"force":{}})",      R"({"set":{}})",
                                R"({"state":{}})",      R"({"release":[]})",
                                R"({"put":[]})",        R"({"put":{}})",
                                R"({"take":[]})",       R"({"start":[]})",
                                R"({"stop":[]})",       R"({"force":{"L_P_AGV_I_P2":true},"release":[]})",
                                R"({"force":[]})",      R"({"force":null})",
                                R"({"force":"all"})",   R"({"release":"none"})",
                                R"({"release":true})",  R"({"start":1})",
                                R"({"start":[1]})",     R"({"state":{"L_P_AGV":1}})",
                                R"({"take":{}})",       R"({"run":1})",
                                R"({"run":false})",     R"({"freeze":"true"})",
                                R"({"reset":null})",    R"({"step":true})",
                                R"({"speed":"2"})",     R"({"speed":null})",
                                R"({"speed":[]})",      R"({"snapshot":1})",
                                R"({"restore":["a"]})", R"({"forget":{}})",
                                R"({"exercise":1})",    R"({"end":true})",
                                R"({"session":null})"}) {
    INFO(act);
    const HttpAnswer answer = bench.post(act);
    INFO(answer.body);
    CHECK(answer.status == 422);
    CHECK(answer.body.size() > 20);
  }
  CHECK(bench.value("AGV_I_P2") == false);
}

TEST_CASE("A check answers as the act would, and does nothing") {
  const PanelBench bench;
  const std::string body = R"({"acts":[{"force":{"L_P_AGV_I_P2":true}}]})";
  CHECK(bench.send(bench.request("POST", "/api/v1/check", body)).status == 200);
  CHECK(bench.value("AGV_I_P2") == false);
}

TEST_CASE("With a PLC, the speed is that of real time") {
  PanelPlan plan;
  plan.with_plc = true;
  const PanelBench bench(plan);
  CHECK(bench.get("/api/v1/plant").at("with_plc") == true);
  const HttpAnswer answer = bench.post(R"({"speed":2})");
  CHECK(answer.status == 422);
  CHECK(contains(answer.body, "real time"));
}

TEST_CASE("An act that arrives after its time is not done") {
  const PanelBench bench;
  const Json picture = bench.picture();
  const auto now = picture.at("now").get<std::int64_t>();
  const auto post = [&](const std::string& until) {
    return bench.send(
        bench.request("POST", "/api/v1/acts", R"({"acts":[{"set":{"L_P_EYE_I_ON":true}}],"until":)" + until + "}"));
  };
  const HttpAnswer late = post(std::to_string(now - 1));
  CHECK(late.status == 422);
  CHECK(contains(late.body, "it came too late, and was not done"));
  CHECK(bench.value("EYE_I_ON") == false);
  CHECK(post("\"soon\"").status == 400);
  CHECK(post("1e3").status == 400);
  CHECK(post(std::to_string(now + 600'000)).status == 200);
  CHECK(bench.value("EYE_I_ON") == true);
  CHECK(bench.picture().at("acts").size() == 1);
}

TEST_CASE("An act to which the plant gets after its time is not done, and the next one is") {
  PanelBench bench;
  const auto now = bench.picture().at("now").get<std::int64_t>();
  bench.hold(true);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  HttpClient client(bench.port);
  client.send(bench.request(
      "POST", "/api/v1/acts",
      R"({"acts":[{"set":{"L_P_EYE_I_ON":true}},{"freeze":true}],"until":)" + std::to_string(now + 3000) + "}"));
  bench.wait_for([&] { return bench.picture().at("now").get<std::int64_t>() > now + 3000; });
  bench.hold(false);
  const HttpAnswer late = client.answer();
  CHECK(late.status == 422);
  CHECK(contains(late.body, "it came too late, and was not done"));
  CHECK(bench.value("EYE_I_ON") == false);
  CHECK(bench.picture().at("clock").at("state") == "running");
  CHECK(bench.picture().at("acts").empty());
  bench.act(R"({"set":{"L_P_EYE_I_ON":true}})");
  CHECK(bench.value("EYE_I_ON") == true);
}

TEST_CASE("Acts at the end of a run are answered") {
  PanelBench bench;
  HttpClient client(bench.port);
  bench.act(R"({"freeze":true})");
  client.send(bench.request("GET", "/api/v1/picture"));
  CHECK(client.answer().status == 200);
  bench.end();
  CHECK(!HttpClient(bench.port).raw().connected());
}

}  // namespace
}  // namespace symplant::test

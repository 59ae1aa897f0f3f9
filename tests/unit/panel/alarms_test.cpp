// Alarms of a plant at its panel: what comes and goes by itself, and what clients do with them.
#include "description/plant_file.hpp"
#include "support/golden.hpp"
#include "symplant/host/read_replay.hpp"
#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

/// A lamp, an inverted lamp and a message as alarms, a requirement of each kind.
struct AlarmPlan : PanelPlan {
  AlarmPlan() {
    names.insert(names.end(), {"LAMP_O_FAULT", "SIGN_O_OK"});
    description::Description& description = reported.description;
    description.inverted = {"L_P_SIGN_O_OK"};
    description.requirements.push_back({"never open in P2", "L_P_AGV.P2 and L_P_DOOR.OPEN2", "", "", 0, ""});
    description.requirements.push_back({"seen", "", "L_P_AGV.P2", "L_P_EYE_I_ON", 50 * kMs, ""});
    reported.disables("DOOR", "OPEN2", "AGV");
    const BenchTables tables(names, reported);
    symbols.resize(tables.rows.symbols.size());
    symbols[tables.symbol("LAMP_O_FAULT")].comment = "The lamp <b>fault</b> is on";
    alarms = {{.symbol = tables.symbol("LAMP_O_FAULT")},
              {.symbol = tables.symbol("SIGN_O_OK"), .priority = tables::AlarmPriority::low}};
    view.symbols = symbols;
    view.alarms = alarms;
  }
  AlarmPlan(const AlarmPlan&) = delete;
  AlarmPlan& operator=(const AlarmPlan&) = delete;

  std::vector<panel::SymbolView> symbols;
  std::vector<panel::AlarmView> alarms;
};

constexpr const char* kFault = "L_P_LAMP_O_FAULT";

/// An alarm of the picture; null: it is not in the list.
Json alarm(const PanelBench& bench, const std::string& name) {
  const Json picture = bench.picture();
  for (const Json& entry : picture.at("alarms").at("list")) {
    if (entry.at("name") == name) return entry;
  }
  return nullptr;
}

std::string state(const PanelBench& bench, const std::string& name) {
  const Json entry = alarm(bench, name);
  return entry.is_null() ? "" : entry.at("state").get<std::string>();
}

Json act_of(const char* const key, const std::string& name) { return Json{{key, name}}; }

void acknowledge(const PanelBench& bench, const std::string& name) { bench.act(act_of("acknowledge", name).dump()); }

TEST_CASE("An operation of `alarms` is an alarm while it is on, with its comment, its station and its time") {
  const AlarmPlan plan;
  const PanelBench bench(plan);
  CHECK(state(bench, kFault) == "");
  const tables::Time came = bench.act(R"({"set":{"L_P_LAMP_O_FAULT":true}})");
  const Json entry = alarm(bench, kFault);
  CHECK(entry.at("state") == "active");
  CHECK(entry.at("came") == came);
  CHECK(entry.at("text") == "The lamp <b>fault</b> is on");
  CHECK(entry.at("station") == 0);
  CHECK(entry.at("priority") == "high");
  CHECK(entry.at("source") == "alarm");
  CHECK(bench.picture().at("alarms").at("horn") == true);
  acknowledge(bench, kFault);
  CHECK(state(bench, kFault) == "acknowledged");
  bench.act(R"({"set":{"L_P_LAMP_O_FAULT":false}})");
  CHECK(state(bench, kFault) == "");
}

TEST_CASE("An inverted operation is an alarm while its bit is off, and its priority is that of the description") {
  const AlarmPlan plan;
  const PanelBench bench(plan);
  CHECK(state(bench, "L_P_SIGN_O_OK") == "");
  bench.act(R"({"set":{"L_P_SIGN_O_OK":false}})");
  const Json entry = alarm(bench, "L_P_SIGN_O_OK");
  CHECK(entry.at("state") == "active");
  CHECK(entry.at("priority") == "low");
  CHECK(entry.at("text") == "L_P_SIGN_O_OK");
  bench.act(R"({"set":{"L_P_SIGN_O_OK":true}})");
  CHECK(state(bench, "L_P_SIGN_O_OK") == "gone");
}

TEST_CASE("plant.json gives alarms a priority, high by default, and the last one that is given decides") {
  auto reading = description::read_plant_file(
      R"({"symplant":1,"symbols":["a.csv"],"alarms":["L_P_*_O_P?",{"of":"L_P_AGV_O_P2","priority":"low"},
      {"of":"L_P_AGV_O_*","priority":"medium"},{"of":"L_P_AGV_O_P1","priority":"low"},{"of":"L_P_AGV_O_P1"}]})",
      "stem");
  REQUIRE(reading.file);
  Reported reported;
  reported.description.alarms = std::move(reading.file->description.alarms);
  const BenchTables tables({"AGV_I_P1", "AGV_I_P2", "AGV_O_P2", "AGV_O_P1"}, reported);
  const auto& alarms = tables.model().alarms;
  REQUIRE(alarms.size() == 2);
  CHECK(alarms[0].symbol == tables.symbol("AGV_O_P2"));
  CHECK(alarms[0].priority == tables::AlarmPriority::medium);
  CHECK(alarms[1].priority == tables::AlarmPriority::low);
  CHECK(model::Alarm{}.priority == tables::AlarmPriority::high);
  for (const char* const wrong :
       {R"({"priority":"low"})", R"({"of":"X","priority":"urgent"})", R"({"of":"X","prio":1})"}) {
    const auto refused = description::read_plant_file(
        std::string(R"({"symplant":1,"symbols":["a.csv"],"alarms":[)") + wrong + "]}", "stem");
    CHECK(refused.faults.size() == 1);
  }
}

TEST_CASE("A number of a message is an alarm, and another number is another one") {
  PanelPlan numbers;
  numbers.rows = rows_of(numbers.names);
  numbers.rows.push_back({"L_P_PANEL_O_CODE", "", "INT"});
  const BenchTables tables(numbers.reported, numbers.rows);
  const std::vector<panel::AlarmView> alarms = {{.symbol = tables.symbol("PANEL_O_CODE")}};
  numbers.view.alarms = alarms;
  const PanelBench bench(numbers);
  bench.act(R"({"set":{"L_P_PANEL_O_CODE":5}})");
  acknowledge(bench, "L_P_PANEL_O_CODE");
  bench.act(R"({"set":{"L_P_PANEL_O_CODE":7}})");
  const Json entry = alarm(bench, "L_P_PANEL_O_CODE");
  CHECK(entry.at("state") == "active");
  CHECK(entry.at("count") == 2);
  CHECK(entry.at("text") == "L_P_PANEL_O_CODE: 7");
  bench.act(R"({"set":{"L_P_PANEL_O_CODE":0}})");
  CHECK(state(bench, "L_P_PANEL_O_CODE") == "gone");
}

TEST_CASE("A value is an alarm while it is not 0") {
  auto reading = description::read_plant_file(
      R"({"symplant":1,"symbols":["a.csv"],"values":{"L_P_AGV.fault":{"is":"L_P_AGV.P2","trace":"20ms"}}})", "stem");
  REQUIRE(reading.file);
  PanelPlan plan;
  plan.reported.description.values = std::move(reading.file->description.values);
  const std::vector<panel::AlarmView> alarms = {{.value = 0, .priority = tables::AlarmPriority::medium}};
  plan.view.alarms = alarms;
  const PanelBench bench(plan);
  bench.act(R"({"state":{"L_P_AGV":"P2"}})");
  bench.wait_for([&] { return state(bench, "L_P_AGV.fault") == "active"; });
  CHECK(alarm(bench, "L_P_AGV.fault").at("station") == 0);
  bench.act(R"({"state":{"L_P_AGV":"P1"}})");
  bench.wait_for([&] { return state(bench, "L_P_AGV.fault") == "gone"; });
}

TEST_CASE("A requirement is an alarm while its condition is violated") {
  const AlarmPlan plan;
  const PanelBench bench(plan);
  const std::string never = "requirement: never open in P2";
  bench.act(R"({"set":{"L_P_EYE_I_ON":true}},{"state":{"L_P_AGV":"P2","L_P_DOOR":"OPEN2"}})");
  const Json entry = alarm(bench, never);
  CHECK(entry.at("state") == "active");
  CHECK(entry.at("priority") == "high");
  CHECK(entry.at("source") == "requirement");
  CHECK(entry.at("of") == "never open in P2");
  CHECK(entry.at("station") == 0);
  const tables::Time went = bench.act(R"({"state":{"L_P_DOOR":"SHUT1"}})");
  CHECK(state(bench, never) == "gone");
  CHECK(alarm(bench, never).at("went") == went);
}

TEST_CASE("An expectation is an alarm until it is fulfilled") {
  const AlarmPlan plan;
  const PanelBench bench(plan);
  bench.act(R"({"state":{"L_P_AGV":"P2"}})");
  bench.wait_for([&] { return state(bench, "requirement: seen") == "active"; });
  bench.act(R"({"set":{"L_P_EYE_I_ON":true}})");
  CHECK(state(bench, "requirement: seen") == "gone");
}

TEST_CASE("A finding is an alarm while it lasts, if it has an end that is known") {
  const AlarmPlan plan;
  const PanelBench bench(plan);
  const std::string conflict = "finding: conflicting operations of L_P_AGV";
  bench.act(R"({"set":{"L_P_AGV_O_P1":true,"L_P_AGV_O_P2":true}})");
  CHECK(state(bench, conflict) == "active");
  CHECK(alarm(bench, conflict).at("priority") == "medium");
  CHECK(contains(alarm(bench, conflict).at("text").get<std::string>(), "conflicting operations: L_P_AGV"));
  bench.act(R"({"set":{"L_P_AGV_O_P1":false,"L_P_AGV_O_P2":false}})");
  CHECK(state(bench, conflict) == "gone");
  const std::string disabled = "finding: command to a disabled unit of L_P_AGV_O_P2";
  bench.act(R"({"state":{"L_P_AGV":"P1","L_P_DOOR":"OPEN2"}})");
  bench.act(R"({"set":{"L_P_AGV_O_P2":true}})");
  CHECK(state(bench, disabled) == "active");
  bench.act(R"({"set":{"L_P_AGV_O_P2":false}})");
  CHECK(state(bench, disabled) == "gone");
}

TEST_CASE("A shelved alarm comes back after its plant time") {
  const AlarmPlan plan;
  const PanelBench bench(plan);
  bench.act(R"({"set":{"L_P_LAMP_O_FAULT":true}})");
  bench.act(R"({"shelve":"L_P_LAMP_O_FAULT","for":"300ms"})");
  const Json shelved = alarm(bench, kFault);
  CHECK(shelved.at("state") == "shelved");
  CHECK(bench.picture().at("alarms").at("horn") == false);
  bench.wait_for([&] { return state(bench, kFault) == "active"; });
  CHECK(bench.picture().at("t") >= shelved.at("until"));
  CHECK(bench.picture().at("alarms").at("horn") == true);
  bench.act(R"({"shelve":["L_P_LAMP_O_FAULT"],"for":"24h"})");
  bench.act(R"({"unshelve":"L_P_LAMP_O_FAULT"})");
  CHECK(state(bench, kFault) == "active");
  bench.act(R"({"silence":true})");
  CHECK(bench.picture().at("alarms").at("horn") == false);
}

TEST_CASE("An act on alarms that is not possible says why, to check and to acts") {
  const AlarmPlan plan;
  const PanelBench bench(plan);
  bench.act(R"({"set":{"L_P_LAMP_O_FAULT":true}})");
  const auto refused = [&](const std::string& act, int status, const std::string& why) {
    for (const char* const target : {"/api/v1/check", "/api/v1/acts"}) {
      const HttpAnswer answer = bench.send(bench.request("POST", target, "{\"acts\":[" + act + "]}"));
      INFO(act << " " << answer.body);
      CHECK(answer.status == status);
      CHECK(contains(Json::parse(answer.body).at("error").get<std::string>(), why));
    }
  };
  refused(R"({"acknowledge":"L_P_LAMP_O_FUALT"})", 422,
          "alarm `L_P_LAMP_O_FUALT` is not in the list; did you mean `L_P_LAMP_O_FAULT`?");
  refused(R"({"acknowledge":["L_P_LAMP_O_FAULT","x"]})", 422, "alarm `x` is not in the list");
  refused(R"({"acknowledge":true})", 422, "`acknowledge` has the name of an alarm, or a list of names, or \"all\"");
  refused(R"({"acknowledge":[]})", 422, "a list of names");
  refused(R"({"unshelve":"L_P_LAMP_O_FAULT"})", 422, "is not shelved");
  for (const char* const time : {"", R"(,"for":"0s")", R"(,"for":"25h")", R"(,"for":5)", R"(,"for":"soon")"}) {
    refused(std::string(R"({"shelve":"L_P_LAMP_O_FAULT")") + time + "}", 422, "a duration of plant time up to 24 h");
  }
  refused(R"({"shelve":"L_P_LAMP_O_FAULT","for":"1s","run":true})", 400, "are alone in an act");
  refused(R"({"silence":1})", 422, "is not one of its values");
  refused(R"({"acknowlege":"all"})", 400, "did you mean `acknowledge`?");
  bench.act(R"({"shelve":"L_P_LAMP_O_FAULT","for":"1h"})");
  refused(R"({"acknowledge":"L_P_LAMP_O_FAULT"})", 422, "is shelved; `unshelve` it first");
  CHECK(bench.send(bench.request("POST", "/api/v1/check", R"({"acts":[{"unshelve":"L_P_LAMP_O_FAULT"}]})")).status ==
        200);
  CHECK(state(bench, kFault) == "shelved");
}

TEST_CASE("Acts on alarms are in the session and in the trace, and a replay leaves them out") {
  const AlarmPlan plan;
  PanelBench bench(plan);
  bench.act(R"({"set":{"L_P_LAMP_O_FAULT":true}})");
  bench.act(R"({"acknowledge":"all"},{"shelve":"L_P_LAMP_O_FAULT","for":"10min"})");
  bench.act(R"({"force":{"L_P_EYE_I_ON":true}})");
  const Json session = bench.get("/api/v1/session/session");
  CHECK(session.at("acts").at(1).at("act") == Json::parse(R"({"acknowledge":"all"})"));
  CHECK(session.at("acts").at(2).at("act") == Json::parse(R"({"shelve":"L_P_LAMP_O_FAULT","for":"600s"})"));
  const std::string scenario = bench.send(bench.request("GET", "/api/v1/session/scenario")).body;
  CHECK_FALSE(contains(scenario, "acknowledge"));
  bench.act(R"({"reset":true})");
  bench.act(R"({"silence":true})");
  bench.end();
  const std::string trace = read_bytes(bench.folder / "trace.jsonl");
  CHECK(contains(trace, R"("act":{"acknowledge":"all"},"by":"hand"})"));
  CHECK(contains(trace, R"("act":{"silence":true},"by":"hand"})"));
  tables::Time last = 0;
  std::string replayed;
  std::istringstream lines(trace);
  for (std::string line; std::getline(lines, line);) {
    const Json json = Json::parse(line);
    if (json.contains("reset")) break;
    if (json.contains("t")) CHECK(json.at("t") >= last);
    last = json.value("t", last);
    replayed += line + "\n";
  }
  std::ostringstream err;
  const auto replay = host::load_replay(bench.folder.write("before.jsonl", replayed), bench.names, err);
  INFO(err.str());
  REQUIRE(replay);
  for (const std::string& text : replay->texts) CHECK(contains(text, "force"));
  CHECK(replay->texts.size() == 1);
}

TEST_CASE("A reset forgets all alarms, a restore those that came later") {
  const AlarmPlan plan;
  const PanelBench bench(plan);
  bench.act(R"({"set":{"L_P_LAMP_O_FAULT":true}})");
  bench.act(R"({"acknowledge":"L_P_LAMP_O_FAULT"},{"snapshot":"on"})");
  bench.act(
      R"({"set":{"L_P_LAMP_O_FAULT":false,"L_P_SIGN_O_OK":false}},{"state":{"L_P_AGV":"P2","L_P_DOOR":"OPEN2"}})");
  CHECK(state(bench, kFault) == "");
  CHECK(state(bench, "requirement: never open in P2") == "active");
  bench.act(R"({"restore":"on"})");
  CHECK(state(bench, kFault) == "active");  // it is on in the snapshot
  CHECK(bench.picture().at("alarms").at("list").size() == 1);
  bench.act(R"({"reset":true})");
  CHECK(bench.picture().at("alarms").at("list").empty());
  bench.act(R"({"restore":"on"})");
  CHECK(state(bench, kFault) == "active");
}

TEST_CASE("A restore keeps what is still violated, and what went later is on again") {
  const AlarmPlan plan;
  const PanelBench bench(plan);
  const std::string never = "requirement: never open in P2";
  bench.act(R"({"freeze":true},{"state":{"L_P_AGV":"P2","L_P_DOOR":"OPEN2"}})");
  bench.act(R"({"snapshot":"violated"})");
  bench.act(R"({"run":true})");
  bench.wait_for([&] { return bench.picture().at("t") > alarm(bench, never).at("came"); });
  bench.act(R"({"state":{"L_P_DOOR":"SHUT1"}})");
  CHECK(state(bench, never) == "gone");
  bench.act(R"({"restore":"violated"},{"freeze":true})");
  CHECK(state(bench, never) == "active");
}

TEST_CASE("The stream has what changed of the alarms, once") {
  const AlarmPlan plan;
  const PanelBench bench(plan);
  HttpClient client(bench.port);
  client.send(bench.request("GET", "/api/v1/stream"));
  client.read_until("event: picture");
  bench.act(R"({"set":{"L_P_LAMP_O_FAULT":true}})");
  const auto next = [&] {
    for (;;) {
      const std::string event = client.read_until("\n\n");
      REQUIRE(!event.empty());
      const std::size_t data = event.find("\ndata: {");
      if (data == event.npos) continue;
      const Json json = Json::parse(event.substr(data + 7));
      if (json.contains("alarms") && !json.at("alarms").at("all")) return json.at("alarms");
    }
  };
  const Json came = next();
  CHECK(came.at("list").size() == 1);
  CHECK(came.at("horn") == true);
  acknowledge(bench, kFault);
  const Json acknowledged = next();
  CHECK(acknowledged.at("list").at(0).at("state") == "acknowledged");
  CHECK(acknowledged.at("horn") == false);
  bench.act(R"({"set":{"L_P_LAMP_O_FAULT":false}})");
  CHECK(next().at("left") == Json::parse(R"(["L_P_LAMP_O_FAULT"])"));
}

}  // namespace
}  // namespace symplant::test

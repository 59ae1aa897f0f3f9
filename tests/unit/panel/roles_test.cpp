// The roles of the panel: what a viewer, a trainee and a trainer see and may do.
#include <list>
#include <set>

#include "support/malfunction_bench.hpp"
#include "symplant/panel/web/open_port.hpp"
#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

using panel::Role;

const std::string kLesson = R"({
  "symplant-scenario": 1,
  "exercise": { "title": "Bring it to P2", "text": "Go.", "allow": ["L_P_EYE_*", "L_P_DOOR"], "score": { "expect": 5 } },
  "steps": [
    { "plus": "0s", "start": "jam", "text": "Look at the vehicle" },
    { "wait": "L_P_EYE_I_ON", "within": "1h", "text": "Cover the eye" },
    { "wait": "L_P_AGV.P2", "within": "1h", "text": "Bring it to P2" }
  ]
})";

/// A plant with an exercise and malfunctions, and a panel with links for all roles.
struct Class {
  explicit Class(PanelPlan plan = {}) : bench(with_roles(std::move(plan))) {}

  PanelPlan with_roles(PanelPlan plan) {
    plan.options.trainees = true;
    plan.options.files = folder / "files";
    plan.exercise_files = {folder.write("send.json", kLesson)};
    plan.reported = with_malfunctions(R"({"name":"jam","of":"L_P_AGV","stuck":true},
                                         {"name":"eye blind","force":{"L_P_EYE_I_ON":true}},
                                         {"name":"asked","of":"L_P_DOOR","stuck":true,"when":"L_P_AGV_O_P2"})");
    plan.reported.description.requirements.push_back({"not both", "L_P_AGV_O_P1 and L_P_AGV_O_P2", "", "", 0});
    return plan;
  }

  std::string as(Role role, std::string request) const {
    const std::size_t at = request.find(bench.token);
    return request.replace(at, bench.token.size(), bench.tokens[static_cast<std::size_t>(role)]);
  }
  HttpAnswer get(Role role, const std::string& target) const {
    return bench.send(as(role, bench.request("GET", target)));
  }
  Json seen(Role role, const std::string& target = "/api/v1/picture") const {
    const HttpAnswer answer = get(role, target);
    REQUIRE(answer.status == 200);
    return Json::parse(answer.body);
  }
  HttpAnswer act(Role role, const std::string& acts) const {
    return bench.send(as(role, bench.request("POST", "/api/v1/acts", "{\"acts\":[" + acts + "]}")));
  }

  const TemporaryFolder folder;
  const PanelBench bench;
};

std::set<std::string> keys_of(const Json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

TEST_CASE("Each link has its role, and without a token a client on this machine is a viewer") {
  const Class of;
  CHECK(std::set<std::string>(of.bench.tokens.begin(), of.bench.tokens.end()).size() == 3);
  for (const Role role : {Role::viewer, Role::trainee, Role::trainer}) {
    CHECK(of.seen(role, "/api/v1/plant").at("role") == panel::role_name(role));
  }
  std::string without = of.bench.request("GET", "/api/v1/plant");
  without.replace(without.find(of.bench.token), 32, std::string(32, 'x'));
  CHECK(Json::parse(of.bench.send(without).body).at("role") == "viewer");
}

TEST_CASE("Without --panel-trainee only the trainer has a token") {
  const PanelBench bench;
  CHECK_FALSE(bench.panel->has_trainees());
  CHECK(bench.get("/api/v1/plant").at("role") == "trainer");
}

TEST_CASE("No answer to a viewer or a trainee names a malfunction") {
  const Class of;
  REQUIRE(of.act(Role::trainer, R"({"exercise":"send"})").status == 200);
  of.bench.wait_for([&] { return of.bench.picture().at("exercise").at("step") == 1; });
  REQUIRE(
      of.act(Role::trainer, R"({"start":["eye blind"]},{"set":{"L_P_AGV_O_P2":true,"L_P_AGV_O_P1":true}})").status ==
      200);
  of.bench.wait_for([&] { return of.bench.picture().at("malfunctions").size() == 3; });
  of.bench.wait_for([&] { return !of.bench.picture().at("findings").empty(); });
  const std::set<std::string> words{"jam", "eye blind", "asked", "malfunction"};
  for (const char* const target :
       {"/api/v1/plant", "/api/v1/picture", "/api/v1/why?name=L_P_AGV", "/api/v1/why?name=L_P_EYE_I_ON",
        "/api/v1/why?name=L_P_AGV_O_P2", "/api/v1/why?name=not%20both", "/api/v1/chart?symbols=0",
        "/api/v1/utilization?device=0", "/api/v1/utilization.csv"}) {
    for (const Role role : {Role::viewer, Role::trainee}) {
      const std::string body = of.get(role, target).body;
      REQUIRE_FALSE(body.empty());
      for (const std::string& word : words) {
        INFO(target << " as " << panel::role_name(role) << ": " << body);
        CHECK_FALSE(contains(body, word));
      }
    }
  }
  // The trainer sees them: the words above are those of the answers.
  CHECK(contains(of.get(Role::trainer, "/api/v1/picture").body, "eye blind"));
  CHECK(contains(of.get(Role::trainer, "/api/v1/plant").body, "\"ordinary\""));
  CHECK(contains(of.get(Role::trainer, "/api/v1/why?name=L_P_AGV").body, "malfunction `jam`"));
  CHECK(contains(of.get(Role::trainer, "/api/v1/why?name=L_P_EYE_I_ON").body, "forced by malfunction"));
  CHECK(contains(of.get(Role::trainer, "/api/v1/why?name=L_P_AGV_O_P2").body, "malfunction `asked` reads it"));
}

TEST_CASE("The flags of malfunctions are the trainer's") {
  const Class of;
  REQUIRE(of.act(Role::trainer, R"({"start":["jam","eye blind"]})").status == 200);
  const auto agv = of.bench.tables.unit_index("AGV");
  const auto eye = of.bench.tables.symbol("EYE_I_ON");
  CHECK(of.seen(Role::trainer).at("devices").at(agv).at(2) == 4 + 16);
  CHECK(of.seen(Role::trainer).at("symbols").at(eye).at(1) == 2);
  CHECK(of.seen(Role::trainee).at("devices").at(agv).at(2) == 0);  // only the malfunction disables it
  CHECK(contains(of.get(Role::trainer, "/api/v1/why?name=L_P_AGV").body, "disabled"));
  CHECK_FALSE(contains(of.get(Role::trainee, "/api/v1/why?name=L_P_AGV").body, "disabled"));
  CHECK(of.seen(Role::trainee).at("symbols").at(eye).at(1) == 0);
  CHECK(of.seen(Role::trainee).at("symbols").at(eye).at(0) == true);
}

TEST_CASE("A stream of a trainee has what changed, without what is for the trainer") {
  const Class of;
  HttpClient trainee(of.bench.port);
  trainee.send(of.as(Role::trainee, of.bench.request("GET", "/api/v1/stream")));
  HttpClient trainer(of.bench.port);
  trainer.send(of.as(Role::trainer, of.bench.request("GET", "/api/v1/stream")));
  CHECK(contains(trainee.read_until("event: picture"), "200 OK"));
  CHECK(contains(trainer.read_until("event: picture"), "200 OK"));
  REQUIRE(of.act(Role::trainer, R"({"start":"eye blind"},{"state":{"L_P_DOOR":"OPEN2"}})").status == 200);
  REQUIRE(of.act(Role::trainer, R"({"snapshot":"mark"})").status == 200);
  REQUIRE(of.act(Role::trainee, R"({"state":{"L_P_DOOR":"SHUT1"}})").status == 200);
  const std::string seen = trainee.read_until("SHUT1\"}");
  const std::string all = trainer.read_until("SHUT1\"}");
  CHECK(contains(all, "\"start\":[\"eye blind\"]"));
  CHECK(contains(all, "\"by\":\"trainee\""));
  CHECK(contains(all, "mark"));
  CHECK(contains(seen, "\"devices\":[["));
  CHECK(contains(seen, "\"by\":\"trainee\""));
  for (const char* const word : {"eye blind", "malfunctions", "mark", "OPEN2", "\"by\":\"hand\""}) {
    INFO(word << " in " << seen);
    CHECK_FALSE(contains(seen, word));
  }
}

TEST_CASE("Each role may do its acts, and no others") {
  const Class of;
  REQUIRE(of.act(Role::trainer, R"({"snapshot":"begin"})").status == 200);
  const std::vector<std::string> of_trainer{R"({"force":{"L_P_EYE_I_ON":true}})",
                                            R"({"release":"all"})",
                                            R"({"start":"jam"})",
                                            R"({"stop":"jam"})",
                                            R"({"run":true})",
                                            R"({"freeze":true})",
                                            R"({"step":"cycle"})",
                                            R"({"step":"change"})",
                                            R"({"run":true})",
                                            R"({"speed":1})",
                                            R"({"snapshot":"mark"})",
                                            R"({"restore":"begin"})",
                                            R"({"save":"mark"})",
                                            R"({"forget":"mark"})",
                                            R"({"session":"mark"})",
                                            R"({"state":{"L_P_AGV":"P2"}})",
                                            R"({"set":{"L_P_AGV_O_P2":true}})",
                                            R"({"exercise":"send"})",
                                            R"({"count":"utilization"})",
                                            R"({"end":"exercise"})",
                                            R"({"reset":true})"};
  const std::vector<std::string> of_trainee{R"({"set":{"L_P_EYE_I_ON":true}})", R"({"state":{"L_P_DOOR":"OPEN2"}})"};
  for (const std::string& act : of_trainer) {
    INFO(act);
    CHECK(of.act(Role::viewer, act).status == 403);
    CHECK(of.act(Role::trainee, act).status == 403);
    CHECK(of.act(Role::trainee, of_trainee.front() + "," + act).status == 403);
  }
  CHECK(of.bench.value("EYE_I_ON") == false);  // nothing of a refused request is done
  for (const std::string& act : of_trainer) {
    INFO(act);
    CHECK(of.act(Role::trainer, act).status == 200);
  }
  for (const std::string& act : of_trainee) {
    INFO(act);
    CHECK(of.act(Role::viewer, act).status == 403);
    CHECK(of.act(Role::trainee, act).status == 200);
    CHECK(of.act(Role::trainer, act).status == 200);
  }
  for (const char* const file : {"scenario", "session", "junit"}) {
    CHECK(of.get(Role::trainee, std::string("/api/v1/session/") + file).status == 403);
    CHECK(of.get(Role::viewer, std::string("/api/v1/session/") + file).status == 403);
    CHECK(of.get(Role::trainer, std::string("/api/v1/session/") + file).status == 200);
  }
}

TEST_CASE("An exercise decides what a trainee may operate, until it ends") {
  const Class of;
  const auto eye = of.bench.tables.symbol("EYE_I_ON");
  const auto door = of.bench.tables.unit_index("DOOR");
  // Before the exercise: what persons operate in a plant, which are the door and the eye that no operation moves.
  Json allowed = of.seen(Role::trainee).at("allowed");
  CHECK(allowed.at("symbols") ==
        Json::array({of.bench.tables.symbol("DOOR_I_SHUT1"), of.bench.tables.symbol("DOOR_I_OPEN2"), eye}));
  CHECK(allowed.at("devices") == Json::array({door, of.bench.tables.unit_index("EYE")}));
  REQUIRE(of.act(Role::trainer, R"({"exercise":"send"})").status == 200);
  of.bench.wait_for([&] { return of.bench.picture().at("exercise").at("step") == 1; });
  allowed = of.seen(Role::trainee).at("allowed");
  CHECK(allowed.at("symbols") == Json::array({eye}));
  CHECK(allowed.at("devices") == Json::array({door}));
  CHECK(allowed.at("values").empty());
  const HttpAnswer refused = of.act(Role::trainee, R"({"set":{"L_P_AGV_O_P2":true}})");
  CHECK(refused.status == 403);
  CHECK(contains(refused.body, "a trainee may not operate `L_P_AGV_O_P2`"));
  CHECK(of.act(Role::trainee, R"({"set":{"L_P_EYE_I_ON":true}})").status == 200);
  of.bench.wait_for([&] { return of.bench.picture().at("exercise").at("step") == 2; });
}

TEST_CASE("A trainee sees the steps of an exercise, and neither what they do nor the score, unless it is shown") {
  const Class of;
  REQUIRE(of.act(Role::trainer, R"({"exercise":"send"})").status == 200);
  of.bench.wait_for([&] { return of.bench.picture().at("exercise").at("step") == 1; });
  const Json seen = of.seen(Role::trainee).at("exercise");
  CHECK(keys_of(seen) == std::set<std::string>{"name", "title", "text", "state", "step", "steps", "since", "took"});
  CHECK(keys_of(seen.at("steps").at(1)) == std::set<std::string>{"text", "state", "t"});
  CHECK(of.seen(Role::trainer).at("exercise").at("steps").at(0).contains("does"));
  CHECK(of.seen(Role::trainee).at("snapshots").empty());
}

TEST_CASE("A trainee reads no step that is still to come, and no list of exercises") {
  const Class of;
  REQUIRE(of.act(Role::trainer, R"({"exercise":"send"})").status == 200);
  of.bench.wait_for([&] { return of.bench.picture().at("exercise").at("step") == 1; });
  const Json steps = of.seen(Role::trainee).at("exercise").at("steps");
  CHECK(steps.at(0).at("text") == "Look at the vehicle");
  CHECK(steps.at(1).at("text") == "Cover the eye");
  CHECK(steps.at(2).at("text") == "");
  CHECK(of.seen(Role::trainer).at("exercise").at("steps").at(2).at("text") == "Bring it to P2");
  CHECK(of.seen(Role::trainee, "/api/v1/plant").at("exercises").empty());
}

TEST_CASE("A stream does not show a trainee that a malfunction starts, nor that the trainer acts") {
  const Class of;
  HttpClient trainee(of.bench.port);
  trainee.send(of.as(Role::trainee, of.bench.request("GET", "/api/v1/stream")));
  trainee.read_until("event: picture");
  trainee.read_until("\n\n");
  REQUIRE(of.act(Role::trainee, R"({"set":{"L_P_EYE_I_ON":true}})").status == 200);
  trainee.read_until("EYE_I_ON");  // what changed at the start has been sent
  trainee.read_until("\n\n");
  // The vehicle is at rest: nothing but the mark of the malfunction changes.
  REQUIRE(of.act(Role::trainer, R"({"start":"L_P_AGV slow"})").status == 200);
  REQUIRE(of.act(Role::trainer, R"({"snapshot":"mark"})").status == 200);
  REQUIRE(of.act(Role::trainee, R"({"state":{"L_P_DOOR":"OPEN2"}})").status == 200);
  const std::string seen = trainee.read_until("OPEN2");
  CHECK_FALSE(contains(seen, "\"acts\":[]"));
  CHECK_FALSE(contains(seen, "\"findings\":[]"));
  CHECK_FALSE(contains(seen, "\"devices\":[[" + std::to_string(of.bench.tables.unit_index("AGV")) + ","));
  CHECK(contains(seen, "\"acts\":[{\"n\":1,"));  // the second one that the trainee sees
}

TEST_CASE("An error does not name malfunctions to a trainee") {
  const Class of;
  for (const char* const act : {R"({"start":"jamm"})", R"({"stop":"eye"})", R"({"force":{"NO":true}})"}) {
    INFO(act);
    CHECK(of.act(Role::trainee, act).status == 403);
    CHECK_FALSE(contains(of.act(Role::trainee, act).body, "did you mean"));
    CHECK(of.act(Role::trainer, act).status == 422);
  }
}

TEST_CASE("A button that a trainee holds as the exercise ends can be released") {
  const Class of;
  REQUIRE(of.act(Role::trainer, R"({"exercise":"send"})").status == 200);
  of.bench.wait_for([&] { return of.bench.picture().at("exercise").at("step") == 1; });
  REQUIRE(of.act(Role::trainee, R"({"set":{"L_P_EYE_I_ON":true}})").status == 200);
  CHECK(of.act(Role::trainee, R"({"set":{"L_P_DOOR_I_SHUT1":false}})").status == 403);
  REQUIRE(of.act(Role::trainer, R"({"end":"exercise"})").status == 200);
  REQUIRE(of.act(Role::trainee, R"({"set":{"L_P_EYE_I_ON":false}})").status == 200);
  CHECK(of.bench.value("EYE_I_ON") == false);
}

TEST_CASE("An exercise can show its score to the trainee") {
  PanelPlan plan;
  plan.options.trainees = true;
  const TemporaryFolder folder;
  plan.exercise_files = {folder.write("send.json", R"({"symplant-scenario":1,
    "exercise":{"title":"T","show_score":true,"score":{"expect":5}},"steps":[{"wait":"L_P_AGV.P2","within":"1h"}]})")};
  const PanelBench bench(plan);
  bench.act(R"({"exercise":"send"})");
  std::string request = bench.request("GET", "/api/v1/picture");
  request.replace(request.find(bench.token), bench.token.size(), bench.tokens[1]);
  CHECK(Json::parse(bench.send(request).body).at("exercise").at("most") == 5);
}

TEST_CASE("A restore, a reset and their pictures go to every role as it sees them") {
  const Class of;
  HttpClient trainee(of.bench.port);
  trainee.send(of.as(Role::trainee, of.bench.request("GET", "/api/v1/stream")));
  trainee.read_until("event: picture");
  REQUIRE(of.act(Role::trainer, R"({"start":"eye blind"},{"reset":true})").status == 200);
  const std::string again = trainee.read_until("event: picture") + trainee.read_until("\n\n");
  CHECK(contains(again, "\"allowed\""));
  CHECK_FALSE(contains(again, "malfunctions"));
}

TEST_CASE("A file may have the tokens of all roles, and those that it lacks are new") {
  const TemporaryFolder folder;
  PanelPlan plan;
  plan.options.trainees = true;
  const std::string a(32, 'a');
  const std::string b(32, 'b');
  plan.options.token_file = folder.write("tokens", a + "\n" + b + "\n");
  const PanelBench bench(plan);
  CHECK(bench.tokens[2] == a);
  CHECK(bench.tokens[1] == b);
  CHECK(bench.tokens[0] != a);
  CHECK(bench.tokens[0].size() == 32);
  panel::PanelOptions equal = plan.options;
  equal.address = "127.0.0.1:0";
  equal.token_file = folder.write("equal", a + "\n" + a + "\n");
  const auto refused = panel::open_port(equal);
  REQUIRE(std::holds_alternative<link::LinkError>(refused));
  CHECK(contains(std::get<link::LinkError>(refused).message, "are equal"));
}

TEST_CASE("Of eight streams one is for a trainer, in whatever order they come") {
  const Class of;
  std::list<HttpClient> clients;
  const auto opens = [&](Role role) {
    clients.emplace_back(of.bench.port);
    clients.back().send(of.as(role, of.bench.request("GET", "/api/v1/stream")));
    return contains(clients.back().read_until("\r\n\r\n"), "200 OK");
  };
  for (int i = 0; i < 7; ++i) CHECK(opens(i % 2 == 0 ? Role::trainee : Role::viewer));
  CHECK_FALSE(opens(Role::trainee));
  CHECK(opens(Role::trainer));
}

}  // namespace
}  // namespace symplant::test

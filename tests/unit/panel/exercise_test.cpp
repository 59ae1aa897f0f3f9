// Exercises at the panel: steps, points, and their files.
#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

const std::string kExercise = R"({
  "symplant-scenario": 1,
  "exercise": { "title": "Send the vehicle", "text": "Bring it to P2.",
                "score": { "expect": 5, "requirement violated": -10, "within": { "time": "10s", "points": 20 } } },
  "steps": [
    { "plus": "0s", "state": { "L_P_DOOR": "OPEN2" }, "text": "The door opens" },
    { "wait": "L_P_DOOR.SHUT1", "within": "30s", "text": "Close the door" },
    { "wait": "L_P_AGV.P2", "within": "30s" },
    { "plus": "0s", "expect": "L_P_AGV.P1" }
  ]
})";

PanelPlan with_exercise(const TemporaryFolder& folder) {
  PanelPlan plan;
  plan.exercise_files = {folder.write("send.json", kExercise)};
  plan.reported.disables("DOOR", "OPEN2", "AGV");
  plan.reported.description.requirements.push_back({"not both", "L_P_AGV_O_P1 and L_P_AGV_O_P2", "", "", 0});
  return plan;
}

TEST_CASE("An exercise begins after a reset, counts points, and ends") {
  const TemporaryFolder folder;
  const PanelBench bench(with_exercise(folder));
  CHECK(bench.get("/api/v1/plant").at("exercises").at(0).at("title") == "Send the vehicle");
  CHECK(bench.picture().at("exercise").is_null());
  bench.act(R"({"exercise":"send"})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("step") == 1; });
  Json exercise = bench.picture().at("exercise");
  CHECK(exercise.at("steps").at(0).at("state") == "done");
  CHECK(exercise.at("steps").at(1) ==
        Json::parse(
            R"({"text":"Close the door","does":"wait: `L_P_DOOR.SHUT1` within 30 s","state":"active","t":null})"));
  CHECK(exercise.at("steps").at(2).at("text") == "");
  CHECK(exercise.at("most") == 35);
  CHECK(exercise.at("score") == 0);
  bench.act(R"({"state":{"L_P_DOOR":"SHUT1"}},{"set":{"L_P_AGV_O_P1":true,"L_P_AGV_O_P2":true}})");
  bench.act(R"({"set":{"L_P_AGV_O_P1":false}})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("state") == "over"; });
  exercise = bench.picture().at("exercise");
  CHECK(exercise.at("steps").at(2).at("state") == "done");
  CHECK(exercise.at("steps").at(3).at("state") == "failed");
  CHECK(exercise.at("score") == 5 + 5 - 10 + 20);
  CHECK(exercise.at("points").size() == 4);
  CHECK(exercise.at("took") < 10'000'000'000);
  const HttpAnswer junit = bench.send(bench.request("GET", "/api/v1/session/junit"));
  CHECK(contains(junit.body, "name=\"score: 20 of 35\""));
  CHECK(contains(junit.body, "name=\"step 2: Close the door\""));
  CHECK(contains(junit.body, "<failure message=\"it did not hold\"/>"));
}

TEST_CASE("An exercise can be ended, and begun again from its first step") {
  const TemporaryFolder folder;
  const PanelBench bench(with_exercise(folder));
  bench.act(R"({"exercise":"send"})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("step") == 1; });
  bench.act(R"({"end":"exercise"})");
  CHECK(bench.picture().at("exercise").at("state") == "over");
  bench.act(R"({"state":{"L_P_DOOR":"SHUT1"}})");
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  CHECK(bench.picture().at("exercise").at("steps").at(1).at("state") == "pending");
  bench.act(R"({"exercise":"send"})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("step") == 1; });
  CHECK(bench.device("DOOR").at(0) == 1);
}

TEST_CASE("A snapshot of an exercise brings back its step too") {
  const TemporaryFolder folder;
  const PanelBench bench(with_exercise(folder));
  bench.act(R"({"exercise":"send"})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("step") == 1; });
  bench.act(R"({"freeze":true},{"snapshot":"open"})");
  bench.act(R"({"run":true},{"state":{"L_P_DOOR":"SHUT1"}})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("step") == 2; });
  bench.act(R"({"restore":"open"})");
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  bench.act(R"({"set":{"L_P_AGV_O_P2":true}})");  // the door is open again: it waits for that first
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  CHECK(bench.device("AGV").at(0) == 0);
  bench.act(R"({"state":{"L_P_DOOR":"SHUT1"}})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("state") == "over"; });
}

TEST_CASE("After a snapshot from before the exercise, the scenario is over") {
  const TemporaryFolder folder;
  const PanelBench bench(with_exercise(folder));
  bench.act(R"({"snapshot":"before"})");
  bench.act(R"({"exercise":"send"})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("step") == 1; });
  bench.act(R"({"restore":"before"})");
  bench.act(R"({"state":{"L_P_DOOR":"SHUT1"}})");
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  CHECK(bench.picture().at("exercise").at("step") == 1);
}

TEST_CASE("A failed step of an exercise is a finding in words") {
  const TemporaryFolder folder;
  PanelPlan plan = with_exercise(folder);
  plan.exercise_files = {folder.write("fail.json", R"({"symplant-scenario":1,"exercise":{"title":"Fail"},"steps":[
    {"plus":"1ms","expect":"L_P_AGV.P2"}]})")};
  const PanelBench bench(plan);
  bench.act(R"({"exercise":"fail"})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("state") == "over"; });
  const Json finding = bench.picture().at("findings").back();
  CHECK(finding.at("finding") == "expectation failed");
  CHECK(contains(finding.at("text").get<std::string>(), "expected `L_P_AGV.P2`"));
}

TEST_CASE("The page sees how far a scenario is") {
  PanelPlan plan;
  plan.scenario =
      R"({"at":"5ms","set":{"L_P_AGV_O_P2":true}},{"wait":"L_P_EYE_I_ON","within":"1h"},{"plus":"0s","expect":"L_P_EYE_I_ON"})";
  const PanelBench bench(plan);
  const auto scenario = [&] { return bench.picture().at("scenario"); };
  bench.wait_for([&] { return scenario().at("done") == 1; });
  CHECK(scenario().at("steps") == 3);
  CHECK(scenario().at("over") == false);
  CHECK(contains(scenario().at("next").get<std::string>(), "wait: `L_P_EYE_I_ON`"));
  bench.act(R"({"set":{"L_P_EYE_I_ON":true}})");
  bench.wait_for([&] { return scenario().at("over") == true; });
  CHECK(scenario().at("done") == 3);
  CHECK(scenario().at("next") == "");
  bench.act(R"({"reset":true})");
  CHECK(scenario().at("over") == false);
}

}  // namespace
}  // namespace symplant::test

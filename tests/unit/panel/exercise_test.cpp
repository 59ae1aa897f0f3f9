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
  CHECK(exercise.at("steps").at(0).at("does") == "put L_P_DOOR into OPEN2");
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

TEST_CASE("Only expectations give points, not what the trainer's steps do") {
  const TemporaryFolder folder;
  PanelPlan plan = with_fixture();
  plan.exercise_files = {folder.write("own.json", R"({"symplant-scenario":1,
    "exercise":{"title":"Own steps","score":{"expect":5,"within":{"time":"1h","points":20}}},"steps":[
    {"at":"0s","put":{"at":"FIXTURE","kind":"raw"},"state":{"L_P_DOOR":"OPEN2"}},
    {"at":"0s","take":"FIXTURE","set":{"L_P_EYE_I_ON":true}},
    {"at":"0s","start":"L_P_AGV_I_P2 stuck off","force":{"L_P_AGV_I_P1":false}},
    {"at":"0s","stop":"L_P_AGV_I_P2 stuck off"},
    {"wait":"L_P_DOOR.SHUT1","within":"1h"}]})")};
  const PanelBench bench(plan);
  bench.act(R"({"exercise":"own"})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("step") == 4; });
  CHECK(bench.picture().at("exercise").at("score") == 0);
  CHECK(bench.picture().at("exercise").at("most") == 25);
  bench.act(R"({"state":{"L_P_DOOR":"SHUT1"}})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("state") == "over"; });
  CHECK(bench.picture().at("exercise").at("score") == 25);
  const HttpAnswer junit = bench.send(bench.request("GET", "/api/v1/session/junit"));
  CHECK(contains(junit.body, "<testsuites tests=\"2\" failures=\"0\""));
  CHECK(contains(junit.body, "name=\"step 5: wait: `L_P_DOOR.SHUT1` within 3600 s\""));
}

TEST_CASE("A step of an exercise that was refused has failed, says why, and gives no points") {
  const TemporaryFolder folder;
  PanelPlan plan = with_fixture();
  plan.exercise_files = {folder.write("full.json", R"({"symplant-scenario":1,
    "exercise":{"title":"Full","score":{"expect":5}},"steps":[
    {"at":"0s","put":[{"at":"FIXTURE","kind":"raw"},{"at":"FIXTURE","kind":"machined"}]},
    {"at":"1ms","take":"FIXTURE"},{"at":"1ms","take":"FIXTURE","expect":"L_P_AGV.P1"}]})")};
  const PanelBench bench(plan);
  bench.act(R"({"exercise":"full"})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("state") == "over"; });
  const Json picture = bench.picture();
  CHECK(picture.at("exercise").at("steps").at(0).at("state") == "failed");
  CHECK(picture.at("exercise").at("steps").at(1).at("state") == "done");
  CHECK(picture.at("exercise").at("score") == 0);
  const Json& findings = picture.at("findings");
  REQUIRE(findings.size() == 2);
  CHECK(contains(findings.at(0).at("text").get<std::string>(), "no room for a part of kind `machined` at FIXTURE"));
  CHECK(contains(findings.at(1).at("text").get<std::string>(), "no part to take at FIXTURE"));
  const HttpAnswer junit = bench.send(bench.request("GET", "/api/v1/session/junit"));
  CHECK(contains(junit.body, "<testsuites tests=\"3\" failures=\"2\""));
}

TEST_CASE("An exercise that is ended by hand gives no points, and what it waits for is not reached") {
  const TemporaryFolder folder;
  const PanelBench bench(with_exercise(folder));
  bench.act(R"({"exercise":"send"})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("step") == 1; });
  bench.act(R"({"end":"exercise"})");
  const Json ended = bench.picture().at("exercise");
  CHECK(ended.at("state") == "over");
  CHECK(ended.at("score") == 0);
  CHECK(ended.at("steps").at(1).at("state") == "pending");
  bench.act(R"({"end":"exercise"})");
  CHECK(bench.picture().at("exercise") == ended);
  const HttpAnswer junit = bench.send(bench.request("GET", "/api/v1/session/junit"));
  CHECK(contains(junit.body, "name=\"score: 0 of 35\""));
  CHECK(contains(junit.body, "<testsuites tests=\"5\" failures=\"3\""));
}

TEST_CASE("A repeated expectation has a passed test case only after its last turn") {
  const TemporaryFolder folder;
  PanelPlan plan;
  plan.exercise_files = {folder.write("twice.json", R"({"symplant-scenario":1,
    "exercise":{"title":"Twice","score":{"expect":5}},"steps":[
    {"repeat":2,"steps":[{"wait":"L_P_EYE_I_ON","within":"1h"},{"wait":"not L_P_EYE_I_ON","within":"1h"}]}]})")};
  const PanelBench bench(plan);
  bench.act(R"({"exercise":"twice"})");
  bench.act(R"({"set":{"L_P_EYE_I_ON":true}})");
  bench.act(R"({"set":{"L_P_EYE_I_ON":false}})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("score") == 10; });
  bench.act(R"({"end":"exercise"})");
  const HttpAnswer junit = bench.send(bench.request("GET", "/api/v1/session/junit"));
  CHECK(contains(junit.body, "<testsuites tests=\"3\" failures=\"2\""));
  CHECK(bench.picture().at("exercise").at("most") == 20);
}

TEST_CASE("A restore brings back the score, times and step of the exercise, so that nothing counts twice") {
  const TemporaryFolder folder;
  const PanelBench bench(with_exercise(folder));
  bench.act(R"({"exercise":"send"})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("step") == 1; });
  bench.act(R"({"freeze":true},{"snapshot":"open"})");
  const Json open = bench.picture().at("exercise");
  for (int turn = 0; turn < 2; ++turn) {
    bench.act(R"({"state":{"L_P_DOOR":"SHUT1"}},{"run":true})");
    bench.wait_for([&] { return bench.picture().at("exercise").at("step") == 2; });
    CHECK(bench.picture().at("exercise").at("score") == 5);
    bench.act(R"({"freeze":true},{"restore":"open"})");
    CHECK(bench.picture().at("exercise") == open);
  }
}

TEST_CASE(
    "An exercise that was over when a snapshot was taken is over after a restore, with the same points and time") {
  const TemporaryFolder folder;
  const PanelBench bench(with_exercise(folder));
  bench.act(R"({"exercise":"send"})");
  bench.act(R"({"state":{"L_P_DOOR":"SHUT1"}},{"set":{"L_P_AGV_O_P2":true}})");
  bench.wait_for([&] { return bench.picture().at("exercise").at("state") == "over"; });
  const Json over = bench.picture().at("exercise");
  bench.act(R"({"snapshot":"over"})");
  bench.act(R"({"restore":"over"})");
  const tables::Time back = bench.picture().at("t");
  bench.wait_for([&] { return bench.picture().at("t").get<tables::Time>() > back + 20 * kMs; });
  CHECK(bench.picture().at("exercise") == over);
  bench.act(R"({"end":"exercise"})");
  CHECK(bench.picture().at("exercise") == over);
}

TEST_CASE("A restore to before the exercise ends it at the time that it had, and gives no points") {
  const TemporaryFolder folder;
  const TemporaryFolder files;
  PanelPlan plan = with_exercise(folder);
  plan.options.files = files.path();
  const PanelBench bench(plan);
  bench.act(R"({"snapshot":"before"})");
  for (const std::string name : {"before", "saved"}) {
    bench.act(R"({"exercise":"send"})");
    bench.wait_for([&] { return bench.picture().at("exercise").at("step") == 1; });
    bench.act(R"({"save":"saved"})");  // a file has the plant only
    const tables::Time begun = bench.picture().at("t");
    bench.wait_for([&] { return bench.picture().at("t").get<tables::Time>() > begun + 100 * kMs; });
    bench.act("{\"restore\":\"" + name + "\"}");
    const Json ended = bench.picture().at("exercise");
    CHECK(ended.at("state") == "over");
    CHECK(ended.at("took").get<tables::Time>() >= 100 * kMs);
    CHECK(ended.at("score") == 0);
    bench.act(R"({"state":{"L_P_DOOR":"SHUT1"}})");
    CHECK(bench.picture().at("exercise") == ended);
  }
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

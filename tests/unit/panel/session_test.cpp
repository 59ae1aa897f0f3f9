// The session as files: a scenario that replays it, JSON, JUnit.
#include <filesystem>

#include "support/golden.hpp"
#include "symplant/host/run.hpp"
#include "unit/panel/panel_bench.hpp"

namespace symplant::test {
namespace {

/// The lines of a trace after the plant was set back for the last time, without acts, up to a time.
std::vector<std::string> lines_of(const std::string& path, tables::Time end) {
  std::istringstream file(read_bytes(path));
  std::vector<std::string> lines;
  std::string line;
  std::getline(file, line);  // the header
  while (std::getline(file, line)) {
    const Json json = Json::parse(line);
    if (json.contains("reset") || json.contains("restored")) lines.clear();
    if ((json.contains("symbol") || json.contains("part")) && json.at("t") <= end) lines.push_back(line);
  }
  return lines;
}

/// Plays a scenario without a panel; the lines of its trace.
std::vector<std::string> played(const PanelBench& bench, const std::string& scenario, tables::Time end) {
  host::RunOptions options;
  options.scenario = scenario;
  options.trace = bench.folder / "played.jsonl";
  std::ostringstream out;
  std::ostringstream err;
  const int code = host::run({.tables = bench.tables.rows}, options, out, err);
  INFO(err.str());
  CHECK(code == 0);
  return lines_of(options.trace, end);
}

PanelPlan with_files(const TemporaryFolder& files) {
  PanelPlan plan;
  plan.options.files = files.path();
  plan.reported.on_command("AGV", "P1", "P2", {description::Duration::Kind::uniform, 30 * kMs, 70 * kMs});
  plan.reported.on_command("AGV", "P2", "P1", {description::Duration::Kind::uniform, 30 * kMs, 70 * kMs});
  plan.reported.disables("DOOR", "OPEN2", "AGV");
  return plan;
}

/// Acts of all kinds, some in one instant, some in further instants of a frozen plant.
void operate(const PanelBench& bench) {
  const std::vector<std::string> acts = {
      R"({"set":{"L_P_AGV_O_P2":true}})",
      R"({"freeze":true})",
      R"({"force":{"L_P_AGV_I_P2":true}},{"set":{"L_P_EYE_I_ON":true}})",
      R"({"force":{"L_P_AGV_I_P2":false}})",
      R"({"release":"all"})",
      R"({"step":"change"})",
      R"({"run":true})",
      R"({"set":{"L_P_AGV_O_P2":false,"L_P_AGV_O_P1":true}})",
      R"({"state":{"L_P_DOOR":"OPEN2"}})",
      R"({"set":{"L_P_EYE_I_ON":false}},{"set":{"L_P_EYE_I_ON":true}})",
      R"({"state":{"L_P_DOOR":"SHUT1"}})",
  };
  for (const std::string& act : acts) {
    bench.act(act);
    std::this_thread::sleep_for(std::chrono::milliseconds(15));
  }
}

TEST_CASE("A session is saved as a scenario that replays it to the same trace") {
  const TemporaryFolder files;
  PanelBench bench(with_files(files));
  operate(bench);
  const tables::Time end = bench.act(R"({"freeze":true},{"session":"shift"})");
  bench.end();
  const auto lines = lines_of(bench.folder / "trace.jsonl", end);
  CHECK(lines.size() > 10);
  CHECK(played(bench, files / "shift.scenario.json", end) == lines);
}

TEST_CASE("A session after a restore begins with the snapshot") {
  const TemporaryFolder files;
  PanelBench bench(with_files(files));
  bench.act(R"({"set":{"L_P_AGV_O_P2":true}},{"snapshot":"begin"})");
  operate(bench);
  bench.act(R"({"restore":"begin"})");
  operate(bench);
  const tables::Time end = bench.act(R"({"freeze":true},{"session":"shift"})");
  const HttpAnswer download = bench.send(bench.request("GET", "/api/v1/session/scenario"));
  CHECK(contains(download.body, R"({ "restore": "session.start.snapshot" })"));
  const HttpAnswer start = bench.send(bench.request("GET", "/api/v1/session/start"));
  CHECK(contains(start.head, "filename=\"session.start.snapshot\""));
  CHECK(start.body == read_bytes(files / "shift.start.snapshot"));
  bench.end();
  const std::string scenario = read_bytes(files / "shift.scenario.json");
  CHECK(contains(scenario, R"({ "restore": "shift.start.snapshot" })"));
  CHECK(played(bench, files / "shift.scenario.json", end) == lines_of(bench.folder / "trace.jsonl", end));
}

TEST_CASE("A session after a reset begins at time 0, and can be downloaded") {
  const TemporaryFolder files;
  PanelBench bench(with_files(files));
  operate(bench);
  bench.act(R"({"reset":true})");
  operate(bench);
  const tables::Time end = bench.act(R"({"freeze":true})");
  const HttpAnswer download = bench.send(bench.request("GET", "/api/v1/session/scenario"));
  CHECK(contains(download.head, "Content-Disposition: attachment; filename=\"session.scenario.json\""));
  CHECK(bench.send(bench.request("GET", "/api/v1/session/start")).status == 404);
  bench.end();
  const std::string path = bench.folder.write("session.json", download.body);
  CHECK(played(bench, path, end) == lines_of(bench.folder / "trace.jsonl", end));
}

TEST_CASE("What a scenario did in a session is replayed too") {
  const TemporaryFolder files;
  PanelPlan plan = with_files(files);
  plan.scenario =
      R"({"at":"5ms","set":{"L_P_AGV_O_P2":true}},{"wait":"L_P_AGV.P2","within":"1s"},)"
      R"({"plus":"2ms","set":{"L_P_AGV_O_P2":false},"state":{"L_P_DOOR":"OPEN2"}},{"plus":"0s","expect":"L_P_DOOR.OPEN2"},)"
      R"({"plus":"0s","force":{"L_P_AGV_I_P1":true}})";
  PanelBench bench(plan);
  bench.wait_for([&] { return bench.value("AGV_I_P1") == true && bench.device("DOOR").at(0) == 1; });
  bench.act(R"({"release":"all"})");
  const tables::Time end = bench.act(R"({"freeze":true},{"session":"shift"})");
  bench.end();
  CHECK(played(bench, files / "shift.scenario.json", end) == lines_of(bench.folder / "trace.jsonl", end));
}

TEST_CASE("What a scenario did after an event of the same time, it does after it in the replay") {
  const TemporaryFolder files;
  PanelPlan plan;
  plan.options.files = files.path();
  plan.reported.on_command("AGV", "P1", "P2", description::Duration::fixed(50 * kMs));
  plan.reported.on_command("AGV", "P2", "P1", description::Duration::fixed(50 * kMs));
  plan.scenario =
      R"({"at":"5ms","set":{"L_P_AGV_O_P2":true}},{"wait":"L_P_AGV.P2","within":"1s"},)"
      R"({"plus":"0s","set":{"L_P_AGV_O_P2":false,"L_P_AGV_O_P1":true}},{"wait":"L_P_AGV.P1","within":"1s"},)"
      R"({"plus":"0s","set":{"L_P_AGV_O_P1":false},"force":{"L_P_EYE_I_ON":true}})";
  PanelBench bench(plan);
  bench.wait_for([&] { return bench.value("EYE_I_ON") == true; });
  const tables::Time end = bench.act(R"({"freeze":true},{"session":"shift"})");
  bench.end();
  CHECK(contains(read_bytes(files / "shift.scenario.json"), "\"instant\": true"));
  CHECK(played(bench, files / "shift.scenario.json", end) == lines_of(bench.folder / "trace.jsonl", end));
}

TEST_CASE("What was refused is not part of the saved session, and not of the trace") {
  const TemporaryFolder files;
  PanelPlan plan = with_fixture();
  plan.options.files = files.path();
  plan.scenario =
      R"({"at":"2ms","take":"FIXTURE"},{"at":"3ms","put":[{"at":"FIXTURE","kind":"raw"},{"at":"FIXTURE","kind":"raw"}]},)"
      R"({"at":"4ms","put":{"at":"FIXTURE","kind":"raw"},"set":{"L_P_EYE_I_ON":true}})";
  PanelBench bench(plan);
  bench.wait_for([&] { return bench.value("EYE_I_ON") == true; });
  for (const std::string refused :
       {R"({"put":{"at":"FIXTURE","kind":"machined"}})",
        R"({"take":"FIXTURE"},{"take":"FIXTURE"},{"set":{"L_P_EYE_I_ON":false}})", R"({"set":{"L_P_AGV_I_P1":true}})",
        R"({"restore":"missing"})", R"({"set":{"NO":1}})", R"({"set":{"L_P_AGV_O_P2":true}},{"forget":"missing"})"}) {
    CHECK(bench.post(refused).status == 422);
  }
  const tables::Time end = bench.act(R"({"freeze":true},{"session":"shift"})");
  const Json acts = bench.picture().at("acts");
  CHECK(acts.at(0).at("act") == Json::parse(R"({"put":[{"at":"FIXTURE","kind":"raw"}]})"));
  CHECK(acts.at(1).at("act") == Json::parse(R"({"set":{"L_P_EYE_I_ON":true}})"));
  CHECK(acts.at(2).at("act") == Json::parse(R"({"take":["FIXTURE"]})"));
  CHECK(acts.at(3).at("act") == Json::parse(R"({"set":{"L_P_EYE_I_ON":false}})"));
  CHECK(acts.at(4).at("act") == Json::parse(R"({"set":{"L_P_AGV_O_P2":true}})"));
  CHECK(acts.size() == 7);  // and the last two
  bench.end();
  CHECK(!contains(read_bytes(bench.folder / "trace.jsonl"), "machined"));
  CHECK(played(bench, files / "shift.scenario.json", end) == lines_of(bench.folder / "trace.jsonl", end));
}

TEST_CASE("Malfunctions that could not start are not part of the saved session") {
  const TemporaryFolder files;
  PanelPlan plan;
  plan.options.files = files.path();
  plan.names.clear();
  std::string list;
  for (int i = 0; i < 66; ++i) {
    plan.names.push_back("PE" + std::to_string(i) + "_I_PART");
    list += (i == 0 ? "\"" : ",\"") + ("L_P_" + plan.names.back() + " stuck on\"");
  }
  PanelBench bench(plan);
  const HttpAnswer answer = bench.post("{\"start\":[" + list + "]}");
  CHECK(answer.status == 422);
  CHECK(contains(answer.body, "too many malfunctions are active; the other acts were done"));
  CHECK(bench.picture().at("acts").at(0).at("act").at("start").size() == 64);
  const tables::Time end = bench.act(R"({"freeze":true},{"session":"shift"})");
  bench.end();
  CHECK(played(bench, files / "shift.scenario.json", end) == lines_of(bench.folder / "trace.jsonl", end));
}

TEST_CASE("The trace has the acts by hand") {
  const TemporaryFolder files;
  PanelBench bench(with_files(files));
  const tables::Time at = bench.act(R"({"force":{"L_P_AGV_I_P2":true}})");
  bench.end();
  CHECK(contains(read_bytes(bench.folder / "trace.jsonl"),
                 "{\"t\":" + std::to_string(at) +
                     ",\"act\":{\"force\":{\"L_P_AGV_I_P2\":true}},\"by\":\"hand\"}\n{\"t\":" + std::to_string(at) +
                     ",\"symbol\":\"L_P_AGV_I_P2\",\"value\":true}\n"));
}

TEST_CASE("The session as JSON and JUnit has acts, findings and requirements") {
  const TemporaryFolder files;
  PanelPlan plan = with_files(files);
  plan.reported.description.requirements.push_back({"not <both>", "L_P_AGV_O_P1 and L_P_AGV_O_P2", "", "", 0});
  const PanelBench bench(plan);
  bench.act(R"({"set":{"L_P_AGV_O_P1":true,"L_P_AGV_O_P2":true}})");
  const Json session = bench.get("/api/v1/session/session");
  CHECK(session.at("symplant-session") == 1);
  CHECK(session.at("acts").at(0).at("act").at("set").size() == 2);
  CHECK(!session.at("findings").empty());
  const HttpAnswer junit = bench.send(bench.request("GET", "/api/v1/session/junit"));
  CHECK(contains(junit.body, "name=\"requirement: not &lt;both&gt;\""));
  CHECK(contains(junit.body, "<failure message=\"violated, 1 in all\"/>"));
}

TEST_CASE("A folder that cannot be written is said, and nothing is lost") {
  const TemporaryFolder files;
  PanelPlan plan;
  plan.options.files = files / "gone";
  const PanelBench bench(plan);
  std::filesystem::remove(files / "gone");
  for (const std::string act : {R"({"save":"a"})", R"({"session":"a"})"}) {
    const HttpAnswer answer = bench.post(act);
    CHECK(answer.status == 422);
    CHECK(contains(answer.body, "cannot write"));
  }
  CHECK(bench.act(R"({"snapshot":"a"})") >= 0);
  CHECK(bench.act(R"({"restore":"a"})") >= 0);
}

TEST_CASE("On a full disk, what cannot be saved is said, and the plant goes on") {
  if (!std::filesystem::exists("/dev/full")) return;
  const TemporaryFolder files;
  for (const std::string name : {"a.snapshot", "a.session.json", "b.junit.xml"}) {
    std::filesystem::create_symlink("/dev/full", files / name);
  }
  const PanelBench bench(with_files(files));
  for (const std::string act : {R"({"save":"a"})", R"({"session":"a"})", R"({"session":"b"})"}) {
    const HttpAnswer answer = bench.post(act);
    CHECK(answer.status == 422);
    CHECK(contains(answer.body, "No space left on device"));
  }
  CHECK(std::filesystem::is_symlink(files / "a.snapshot"));
  CHECK(bench.act(R"({"save":"c"})") >= 0);
}

TEST_CASE("With a PLC the session has no scenario: what the PLC wrote is not known") {
  const TemporaryFolder files;
  PanelPlan plan;
  plan.options.files = files.path();
  plan.with_plc = true;
  const PanelBench bench(plan);
  CHECK(bench.send(bench.request("GET", "/api/v1/session/scenario")).status == 422);
  bench.act(R"({"session":"a"})");
  CHECK(std::filesystem::exists(files / "a.session.json"));
  CHECK(!std::filesystem::exists(files / "a.scenario.json"));
}

}  // namespace
}  // namespace symplant::test

// Tests of the tool with malfunctions: run, map, diff, check.
#include <nlohmann/json.hpp>

#include "app_support.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

/// A vehicle, a sensor and a lamp that only a malfunction reads; plant.json with these malfunctions.
MemoryFileSystem faulty_files(const std::string& malfunctions) {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"L_P_AGV_O_P2", "Y1"},
                                       {"L_P_AGV_I_P1", "X1"},
                                       {"L_P_AGV_I_P2", "X2"},
                                       {"L_P_PE_I_PART", "X3"},
                                       {"RESET", "Y9"}});
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["list.csv"], "malfunctions": [)" + malfunctions + "]}";
  return files;
}

TEST_CASE("run: A scenario starts malfunctions, and the trace has them after the symbols of their instant") {
  MemoryFileSystem files = faulty_files(R"({"name": "blind", "force": {"L_P_PE_I_PART": true}, "lasts": "1s"})");
  const TemporaryFolder folder;
  folder.write("scenario.json",
               R"({"symplant-scenario":1,"steps":[{"at":"1s","start":["L_P_AGV slow","blind"]},{"at":"3s",
                                   "expect":{"L_P_PE_I_PART":true}}]})");
  const ToolRun run = run_tool({"run", "plant.json", "--scenario", folder / "scenario.json", "--trace", "-"}, files);
  CHECK(run.code == 1);
  CHECK(contains(run.out, R"({"t":1000000000,"symbol":"L_P_PE_I_PART","value":true}
{"t":1000000000,"malfunction":"L_P_AGV slow","active":true,"by":"scenario"}
{"t":1000000000,"malfunction":"blind","active":true,"by":"scenario"}
{"t":2000000000,"symbol":"L_P_PE_I_PART","value":false}
{"t":2000000000,"malfunction":"blind","active":false,"by":"end"}
)"));
  CHECK(contains(run.err, "malfunction `L_P_AGV slow` is active since 1 s"));
  CHECK_FALSE(contains(run.err, "malfunction `blind` is active"));
}

TEST_CASE("run: In virtual time, a malfunction that cuts a link is reported as without effect") {
  MemoryFileSystem files =
      faulty_files(R"({"name": "cable", "lose": true}, {"name": "jam", "of": "*", "stuck": true})");
  const ToolRun run = run_tool({"run", "plant.json", "--until", "1s"}, files);
  CHECK(run.code == 0);
  CHECK(contains(run.out, "malfunction `cable` has no effect in virtual time"));
  CHECK_FALSE(contains(run.out, "`jam`"));
}

TEST_CASE("map: A malfunction is what reads the operations of its conditions") {
  MemoryFileSystem files = faulty_files(R"({"name": "jam", "of": "*", "stuck": true, "lasts": "1s", "when": "RESET"},
      {"name": "slow", "of": "*", "slower": 2, "becomes": {"after": "1s", "unless": "RESET", "start": "jam"}})");
  const ToolRun run = run_tool({"map", "plant.json", "--format", "json"}, files);
  REQUIRE(run.code == 0);
  INFO(run.out);
  const nlohmann::json map = nlohmann::json::parse(run.out);
  bool found = false;
  for (const nlohmann::json& one : map.at("links").at(0).at("symbols")) {
    if (one.at("symbol") != "RESET") continue;
    found = true;
    CHECK(one.at("read_by") == nlohmann::json{"malfunction jam", "malfunction slow"});
  }
  CHECK(found);
}

TEST_CASE("diff: Malfunctions that came, went or changed are differences of the plant") {
  MemoryFileSystem files = faulty_files(R"({"name": "jam", "of": "*", "stuck": true}, {"name": "gone", "lose": true})");
  files.files["new.json"] = R"({"symplant": 1, "symbols": ["list.csv"], "malfunctions": [
      {"name": "jam", "of": "L_P_AGV", "stuck": "P2"}, {"name": "blind", "force": {"L_P_PE_I_PART": true}}]})";
  const ToolRun run = run_tool({"diff", "plant.json", "new.json"}, files);
  CHECK(run.code == 1);
  for (const char* part : {"jam", "stuck in P2: L_P_AGV", "gone", "blind"}) CHECK(contains(run.out, part));
}

TEST_CASE("check: All faults of malfunctions are reported at their keys") {
  MemoryFileSystem files = faulty_files(R"({"name": "jam", "of": "L_P_AVG", "stuck": true}, {"name": "L_P_AGV stuck",
      "lose": true}, {"name": "both", "lose": true, "stuck": true, "of": "*"})");
  const ToolRun run = run_tool({"check", "plant.json"}, files);
  CHECK(contains(run.out, "device `L_P_AVG` not found; did you mean `L_P_AGV`?"));
  CHECK(contains(run.out, "`L_P_AGV stuck` is an ordinary malfunction"));
  CHECK(contains(run.out, "exactly one of `slower`, `stuck`, `force`, `flicker`, `lose`, `set`, `distort` "));
}

}  // namespace
}  // namespace symplant::test

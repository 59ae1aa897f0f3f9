// Tests of the tool with plants that have parts or conditions, and no devices.
#include "app_support.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

/// A belt that a number drives, with a photo-eye.
MemoryFileSystem belt_files() {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"BELT_SPEED", "", "INT", "0", "%QW1"}, {"EYE", "X1"}});
  files.files["plant.json"] = R"({ "symplant": 1, "symbols": ["list.csv"], "material": {
      "kinds": { "raw": { "length": "100 mm" } },
      "tracks": { "BELT": { "length": "1 m", "drives": [ { "forward": "BELT_SPEED > 0", "speed": { "of": "BELT_SPEED", "unit": "1 mm/s" } } ],
                            "sensors": [ { "symbol": "EYE", "at": "500 mm" } ], "end": "out" } },
      "sources": [ { "name": "in", "at": "BELT", "kind": "raw", "count": 1 } ] } })";
  return files;
}

TEST_CASE("check: A plant of parts without a device has no error") {
  MemoryFileSystem files = belt_files();
  const ToolRun run = run_tool({"check", "plant.json"}, files);
  INFO(run.out << run.err);
  CHECK(run.code == 0);
  CHECK_FALSE(contains(run.out, "SP415"));
  CHECK(contains(run.out + run.err, "0 devices"));
}

TEST_CASE("check: A plant whose inputs follow conditions, without a device, has no error") {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"LAMP", "Y1"}, {"LAMP_SEEN", "X1"}});
  files.files["plant.json"] = R"({ "symplant": 1, "symbols": ["list.csv"], "follow": { "LAMP_SEEN": "LAMP" } })";
  const ToolRun run = run_tool({"check", "plant.json"}, files);
  INFO(run.out << run.err);
  CHECK(run.code == 0);
  CHECK_FALSE(contains(run.out, "SP415"));
}

TEST_CASE("check: A list whose names all break the rule is one finding also in a plant of parts") {
  MemoryFileSystem files = belt_files();
  std::string rows;
  for (int i = 0; i < 40; ++i)
    rows += "VAR_GLOBAL,Input" + std::to_string(i) + ",X" + std::to_string(100 + i) + ",,BOOL,FALSE\n";
  files.files["list.csv"] += rows;
  const ToolRun run = run_tool({"check", "plant.json"}, files);
  INFO(run.out << run.err);
  CHECK(contains(run.out, "SP208"));
  CHECK_FALSE(contains(run.out, "SP415"));
}

TEST_CASE("A plant of parts without a device is modeled, run, mapped and generated without a finding of errors") {
  MemoryFileSystem files = belt_files();
  CHECK(contains(run_tool({"model", "plant.json"}, files).out, "track BELT: 1 m"));
  CHECK(run_tool({"model", "plant.json", "--format", "svg"}, files).code == 0);
  CHECK(run_tool({"map", "plant.json"}, files).code == 0);
  const TemporaryFolder folder;
  folder.write(
      "scenario.json",
      R"({"symplant-scenario":1,"steps":[{"at":"0s","set":{"BELT_SPEED":100}},{"wait":"EYE"},{"wait":"not BELT.part"}]})");
  const ToolRun run = run_tool({"run", "plant.json", "--scenario", folder / "scenario.json"}, files);
  INFO(run.out << run.err);
  CHECK(run.code == 0);
  CHECK_FALSE(contains(run.out + run.err, "error"));
  const ToolRun generated = run_tool({"generate", "plant.json", "-o", "gen"}, files);
  INFO(generated.out << generated.err);
  CHECK(generated.code == 0);
  CHECK_FALSE(contains(generated.out + generated.err, "error"));
  CHECK(files.files.contains("gen/plant_gen.hpp"));
}

}  // namespace
}  // namespace symplant::test

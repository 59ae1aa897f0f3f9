// A plant of two PLCs with every command.
#include <nlohmann/json.hpp>

#include "unit/app/app_support.hpp"

namespace symplant::test {
namespace {

const std::string kPlant = R"({"symplant": 1, "symbols": [{"file": "press.csv", "controller": "PRESS"},
  {"file": "robot.csv", "controller": "ROBOT"}], "links": [
  {"url": "modbus-tcp-server://127.0.0.1:1", "controller": "PRESS"},
  {"url": "modbus-tcp-server://127.0.0.1:2", "controller": "robot"}]})";

MemoryFileSystem two(const std::string& plant = kPlant) {
  MemoryFileSystem files;
  files.files["press.csv"] = list_text(
      {{"L_P_RAM_O_UP1", "Y1"}, {"L_P_RAM_O_DOWN2", "Y2"}, {"L_P_RAM_I_UP1", "X1"}, {"L_P_RAM_I_DOWN2", "X2"}});
  files.files["robot.csv"] =
      list_text({{"L_H_ARM_O_OUT1", "Y1"}, {"L_H_ARM_O_IN2", "Y2"}, {"L_H_ARM_I_OUT1", "X1"}, {"L_H_ARM_I_IN2", "X2"}});
  files.files["plant.json"] = plant;
  return files;
}

ToolRun run_two(const std::vector<std::string>& arguments, const std::string& plant = kPlant) {
  MemoryFileSystem files = two(plant);
  return run_tool(arguments, files);
}

TEST_CASE("check: Equal addresses of two controllers are no finding, and the result counts the lists") {
  const ToolRun run = run_two({"check", "plant.json", "--fail-on", "warning"});
  CHECK(run.code == 0);
  CHECK(contains(run.out, "plant.json: 8 of 8 I/O names of 2 lists follow"));
}

TEST_CASE("check: The same lists on one controller clash") {
  const ToolRun run = run_two({"check", "plant.json", "--fail-on", "warning"},
                              R"({"symplant": 1, "symbols": ["press.csv", "robot.csv"]})");
  CHECK(run.code == 1);
  CHECK(contains(run.out, "robot.csv:"));
  CHECK(contains(run.out, "event-driven-twice"));
}

TEST_CASE("map: Each controller has a table, its rows named by list and line") {
  const ToolRun run = run_two({"map", "plant.json"});
  CHECK(run.code == 0);
  const std::size_t second = run.out.find("\ncontroller ROBOT\n");
  REQUIRE(second != std::string::npos);
  CHECK(run.out.substr(0, 17) == "controller PRESS\n");
  CHECK(contains(run.out.substr(0, second), "press.csv:2"));
  CHECK_FALSE(contains(run.out.substr(0, second), "robot.csv"));
  CHECK(contains(run.out.substr(second), "robot.csv:2"));
  CHECK(contains(run.out.substr(second), "coil 1"));
}

TEST_CASE("model: The JSON has lists, controllers, and the location of each symbol") {
  const auto model = nlohmann::json::parse(run_two({"model", "plant.json", "--format", "json"}).out);
  CHECK(model.at("lists").at(1) == nlohmann::json{{"file", "robot.csv"}, {"controller", "ROBOT"}});
  CHECK(model.at("symbols").at(3).at("list") == 0);
  CHECK(model.at("symbols").at(4).at("list") == 1);
}

TEST_CASE("run: The plant's own links are closed in virtual time, with a message") {
  const ToolRun run = run_two({"run", "plant.json", "--clock", "virtual", "--until", "1s"});
  CHECK(run.code == 0);
  CHECK(contains(run.out, "I/O symbols from press.csv, robot.csv"));
  CHECK(contains(run.out, "links of the plant are not opened in virtual time"));
}

TEST_CASE("run: A link names its controller, and is reported with its port") {
  const ToolRun run =
      run_two({"run", "plant.json", "--until", "10ms", "--link", "robot=modbus-tcp-server://127.0.0.1:0"});
  CHECK(run.code == 0);
  CHECK(contains(run.out, "\nlink ROBOT=modbus-tcp-server://127.0.0.1:"));
  const ToolRun unsaid = run_two({"run", "plant.json", "--link", "modbus-tcp-server://127.0.0.1:0"});
  CHECK(unsaid.code == 2);
  CHECK(contains(unsaid.err, "write `PRESS=modbus-tcp-server://127.0.0.1:0`"));
  const ToolRun unknown = run_two({"run", "plant.json", "--link", "ROBOTER=loop:"});
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.err, "controller `ROBOTER` not found; did you mean `ROBOT`?"));
}

TEST_CASE("generate: The main program has the links of the description") {
  MemoryFileSystem files = two();
  CHECK(run_tool({"generate", "plant.json", "-o", "out"}, files).code == 0);
  CHECK(contains(files.files["out/main_gen.cpp"], R"({"PRESS", "modbus-tcp-server://127.0.0.1:1"},)"));
  CHECK(contains(files.files["out/tables_gen.cpp"], "{4, 1},  // robot.csv of ROBOT"));
}

TEST_CASE("A link of the description with an unknown controller is reported at its location") {
  const ToolRun run = run_two({"check", "plant.json"},
                              R"({"symplant": 1, "symbols": [{"file": "press.csv", "controller": "PRESS"}],
  "links": [{"url": "loop:", "controller": "PRES"}]})");
  CHECK(run.code == 1);
  CHECK(contains(run.out, "plant.json:2:44: error: controller `PRES` not found; did you mean `PRESS`?"));
}

}  // namespace
}  // namespace symplant::test

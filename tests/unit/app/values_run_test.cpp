// Tests of symplant run with values: their statistics.
#include <nlohmann/json.hpp>

#include "app_support.hpp"
#include "support/temporary_folder.hpp"

namespace symplant::test {
namespace {

constexpr std::string_view kWithValues = R"({
  "symplant": 1, "symbols": ["list.csv"], "defaults": { "step": "1s" },
  "values": {
    "wind": { "unit": "m/s", "start": 3 },
    "level": { "unit": "l", "start": 20, "integral": "2 - 4 * L_P_VALVE_O_OPEN" },
    "deep": { "is": "level + 100" },
    "boom": { "linear": { "a": [[1]], "b": [[1]], "c": [[1], [-2]], "u": ["1"] } },
    "pieces": { "trace": false, "changes": [ { "when": "L_P_VALVE_O_OPEN", "to": "pieces + 1" } ] }
  } })";

TEST_CASE("run: Statistics have the least, the greatest and the last number of each value") {
  const TemporaryFolder folder;
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"L_P_VALVE_O_OPEN", "Y1"}, {"L_P_VALVE_I_OPEN", "X1"}});
  files.files["plant.json"] = kWithValues;
  folder.write("scenario.json", R"({"symplant-scenario":1,"steps":[
      {"at":"5s","set":{"L_P_VALVE_O_OPEN":true}}, {"at":"8500ms","set":{"wind":-1}},
      {"at":"8600ms","set":{"wind":2.5}}, {"at":"9s","set":{"L_P_VALVE_O_OPEN":false}}]})");
  const auto values_of = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{"run", "plant.json", "--stats", folder / "stats.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    CHECK(run_tool(arguments, files).code == 0);
    return nlohmann::json::parse(read_bytes(folder / "stats.json"))["values"];
  };
  // The level rises to 30 at 5 s, as stored then falls from 6 s on to 22 at 10 s.
  const auto values = values_of({"--scenario", folder / "scenario.json", "--until", "10s", "--save", folder / "s"});
  CHECK(values["wind"] == nlohmann::json({{"unit", "m/s"}, {"least", -1}, {"greatest", 3}, {"last", 2.5}}));
  CHECK(values["level"] == nlohmann::json({{"unit", "l"}, {"least", 20}, {"greatest", 30}, {"last", 24}}));
  CHECK(values["deep"] == nlohmann::json({{"unit", ""}, {"least", 120}, {"greatest", 130}, {"last", 124}}));
  CHECK(values["boom[2]"] == nlohmann::json({{"unit", ""}, {"least", -20}, {"greatest", 0}, {"last", -20}}));
  CHECK(values["pieces"]["last"] == 1);
  CHECK(values.size() == 6);
  // A run that goes on counts from its own start.
  const auto later = values_of({"--resume", folder / "s", "--until", "12s"});
  CHECK(later["level"] == nlohmann::json({{"unit", "l"}, {"least", 24}, {"greatest", 28}, {"last", 28}}));
  CHECK(later["wind"]["greatest"] == 2.5);
}

TEST_CASE(
    "run: The trace of a run that goes on shows all values at the first multiple, also those that do not change") {
  const TemporaryFolder folder;
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"L_P_VALVE_O_OPEN", "Y1"}, {"L_P_VALVE_I_OPEN", "X1"}});
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["list.csv"],
      "values": {"p": {"start": 3}, "v": {"is": "5 + p"}, "slow": {"trace": "1s", "start": 7}}})";
  CHECK(run_tool({"run", "plant.json", "--until", "1050ms", "--save", folder / "s"}, files).code == 0);
  const ToolRun run = run_tool({"run", "plant.json", "--resume", folder / "s", "--until", "3s", "--trace", "-"}, files);
  CHECK(contains(run.out,
                 "{\"t\":1100000000,\"value\":\"p\",\"is\":3}\n{\"t\":1100000000,\"value\":\"v\",\"is\":8}\n"
                 "{\"t\":2000000000,\"value\":\"slow\",\"is\":7}\n"));
}

TEST_CASE("run: An instantaneous loop of values says that they change, and names them") {
  const TemporaryFolder folder;
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"L_P_VALVE_O_OPEN", "Y1"}, {"L_P_VALVE_I_OPEN", "X1"}});
  files.files["plant.json"] = R"({"symplant": 1, "symbols": ["list.csv"],
      "malfunctions": [{"name": "m", "of": "L_P_VALVE", "slower": 2}],
      "values": {"echo": {"changes": [{"when": "twin = 0", "to": "1"}, {"when": "twin = 1", "to": "0"}]},
                 "twin": {"changes": [{"when": "echo = 1", "to": "1"}, {"when": "echo = 0", "to": "0"}]}}})";
  const ToolRun run = run_tool({"run", "plant.json", "--until", "1s", "--findings", folder / "f"}, files);
  CHECK(contains(run.err,
                 "0 s: instantaneous loop: echo twin change again and again without time passing and are frozen "
                 "until the run ends; check for `changes` with conditions that depend on what they set"));
  CHECK(contains(read_bytes(folder / "f"), "\"of\":\"echo twin\""));
}

}  // namespace
}  // namespace symplant::test

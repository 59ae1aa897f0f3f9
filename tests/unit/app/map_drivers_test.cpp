// What map and run say that each symbol does.
#include <nlohmann/json.hpp>

#include "app_support.hpp"

namespace symplant::test {
namespace {

using nlohmann::json;

MemoryFileSystem tank() {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"L_P_PUMP_O_ON1", "Y1"},
                                       {"L_P_PUMP_I_ON1", "X1"},
                                       {"L_P_PUMP_I_OFF2", "X2"},
                                       {"SPEED", "", "WORD", "0", "%QW5"},
                                       {"LIMIT", "", "WORD", "0", "%QW6"},
                                       {"UNUSED", "", "WORD", "0", "%QW7"},
                                       {"L_P_TANK_O_TARGET", "", "WORD", "0", "%QW8"},
                                       {"L_P_TANK_I_LEVEL", "", "WORD", "0", "%IW8"},
                                       {"L_P_TANK_I_FULL", "X3"},
                                       {"DOOR", "X4"},
                                       {"HEALTHY", "X5"},
                                       {"LAMP", "Y2"},
                                       {"CLOCK", "", "WORD", "0", "%QW9"}});
  files.files["plant.json"] = R"json({"symplant": 1, "symbols": ["list.csv"],
    "devices": {
      "L_P_PUMP": {"transitions": [{"from": "OFF2", "to": "ON1", "on": "ON1", "when": "SPEED > 5"}]},
      "L_P_TANK": {"behaviour": "Tank", "inputs": {"full": "LIMIT > 3 and SPEED > 7"}}},
    "follow": {"HEALTHY": "LAMP"},
    "requirements": [{"name": "slow", "never":
      "LIMIT > 9 and (DOOR or HEALTHY or L_P_PUMP_I_ON1 or L_P_PUMP_I_OFF2 or L_P_TANK_I_FULL or L_P_PUMP_O_ON1 or SPEED > 1)"
}],
    "links": [{"url": "loop:", "clock": {"of": "CLOCK"}}]
})json";
  return files;
}

json symbol(const json& link, const std::string& name) {
  for (const json& one : link.at("symbols")) {
    if (one.at("symbol") == name) return one;
  }
  FAIL("no symbol " + name);
  return {};
}

TEST_CASE(
    "map: What a condition, a requirement or a behavior reads is shown, and what a behavior or a condition drives") {
  MemoryFileSystem files = tank();
  const ToolRun run = run_tool({"map", "plant.json", "--format", "json"}, files);
  INFO(run.err);
  REQUIRE(run.code == 0);
  const json link = json::parse(run.out).at("links").at(0);
  CHECK(symbol(link, "SPEED").at("read_by") == json{"L_P_PUMP", "L_P_TANK", "requirement slow"});
  CHECK(symbol(link, "SPEED").at("moves").is_null());
  CHECK(symbol(link, "LIMIT").at("read_by") == json{"L_P_TANK", "requirement slow"});
  CHECK(symbol(link, "UNUSED").at("read_by").empty());
  CHECK(symbol(link, "L_P_TANK_O_TARGET").at("read_by") == json::array({"L_P_TANK"}));
  CHECK(symbol(link, "LAMP").at("read_by") == json::array({"HEALTHY"}));
  CHECK(symbol(link, "CLOCK").at("read_by") == json::array({"plant time"}));
  CHECK(symbol(link, "L_P_PUMP_O_ON1").at("moves") == "L_P_PUMP");
  CHECK(symbol(link, "L_P_PUMP_I_ON1").at("driven_by") == "L_P_PUMP");
  CHECK(symbol(link, "L_P_TANK_I_LEVEL").at("driven_by") == "L_P_TANK");
  CHECK(symbol(link, "L_P_TANK_I_FULL").at("driven_by") == "L_P_TANK");
  CHECK(symbol(link, "HEALTHY").at("driven_by") == "a condition");
  CHECK(symbol(link, "DOOR").at("driven_by").is_null());
}

TEST_CASE("map: The table has the same drivers, and `-` for none") {
  MemoryFileSystem files = tank();
  const std::string out = run_tool({"map", "plant.json"}, files).out;
  CHECK(contains(out, "driven by    drives\n"));
  CHECK(contains(out, "the PLC      L_P_PUMP, L_P_TANK\n"));
  CHECK(contains(out, "the PLC      plant time\n"));
  CHECK(contains(out, "the PLC      -\n"));
  CHECK(contains(out, "30009    L_P_TANK\n"));
  CHECK(contains(out, "10005    -\n"));
}

TEST_CASE("run: Operations that conditions read are used, and inputs that conditions drive are driven") {
  MemoryFileSystem files = tank();
  const ToolRun run = run_tool({"run", "plant.json", "--until", "1ms", "--link", "loop:", "--clock", "virtual"}, files);
  INFO(run.err);
  CHECK(contains(run.out, "using 4 of 7 operations"));  // the behavior has no code here, the clock is not used
  CHECK(contains(run.out, "not driven: 2 of 6 events: L_P_TANK_I_LEVEL, DOOR\n"));
}

/// Operations that drive what is no device.
MemoryFileSystem belts() {
  MemoryFileSystem files;
  files.files["list.csv"] = list_text({{"RUN", "Y1"},
                                       {"HOLD", "Y2"},
                                       {"LEFT", "Y3"},
                                       {"PICK", "Y4"},
                                       {"MILL", "Y5"},
                                       {"FEED", "Y6"},
                                       {"HEAT", "Y7"},
                                       {"LAMP", "Y8"},
                                       {"WATCHED", "Y9"},
                                       {"FAST", "", "INT", "0", "%QW10"},
                                       {"EYE", "X1"},
                                       {"ECHO", "X2"}});
  files.files["plant.json"] = R"json({"symplant": 1, "symbols": ["list.csv"],
    "material": {
      "kinds": {"raw": {"length": "200 mm"}, "done": {"length": "200 mm"}},
      "tracks": {
        "CV1": {"length": "2 m", "drives": [{"forward": "RUN", "speed": {"of": "FAST", "unit": "1 mm/s"}}],
                "stops": [{"at": "1 m", "when": "HOLD"}], "end": [{"to": "CV2", "when": "LEFT"}, {"to": "out"}],
                "sensors": [{"symbol": "EYE", "at": "500 mm"}]},
        "CV2": {"length": "1 m", "drives": [{"forward": "RUN", "speed": "0.4 m/s"}]}},
      "places": {"FIXTURE": {}},
      "transfers": [{"name": "pick", "from": "CV2", "to": "FIXTURE", "when": "PICK"}],
      "work": [{"name": "mill", "at": "FIXTURE", "when": "MILL", "from": "raw", "to": "done"}],
      "sources": [{"name": "infeed", "at": "CV1", "kind": "raw", "when": "FEED"}]},
    "follow": {"ECHO": "LAMP"},
    "malfunctions": [{"name": "hot", "force": {"ECHO": false}, "when": "HEAT"}],
    "requirements": [{"name": "slow", "never": "WATCHED"}]})json";
  return files;
}

TEST_CASE("map: What an operation drives is named, whether it is a device or not") {
  MemoryFileSystem files = belts();
  const ToolRun run = run_tool({"map", "plant.json", "--format", "json"}, files);
  INFO(run.err);
  REQUIRE(run.code == 0);
  const json link = json::parse(run.out).at("links").at(0);
  const auto drives = [&](const std::string& name) { return symbol(link, name).at("drives"); };
  CHECK(drives("RUN") == json{"track CV1", "track CV2"});
  CHECK(drives("HOLD") == json::array({"track CV1"}));
  CHECK(drives("LEFT") == json::array({"track CV1"}));
  CHECK(drives("FAST") == json::array({"track CV1"}));
  CHECK(drives("PICK") == json::array({"transfer pick"}));
  CHECK(drives("MILL") == json::array({"work mill"}));
  CHECK(drives("FEED") == json::array({"source infeed"}));
  CHECK(drives("HEAT") == json::array({"malfunction hot"}));
  CHECK(drives("LAMP") == json::array({"ECHO"}));
  CHECK(drives("WATCHED") == json::array());
  CHECK(symbol(link, "WATCHED").at("read_by") == json::array({"requirement slow"}));
  CHECK(drives("EYE") == json::array());
  CHECK(symbol(link, "EYE").at("driven_by") == "parts at CV1");
  CHECK(symbol(link, "ECHO").at("driven_by") == "a condition");
  const std::string table = run_tool({"map", "plant.json"}, files).out;
  CHECK(contains(table, "the PLC       track CV1, track CV2\n"));
  CHECK(contains(table, "the PLC       - (read by requirement slow)\n"));
  const std::string csv = run_tool({"map", "plant.json", "--format", "csv"}, files).out;
  CHECK(contains(csv, ",on loss,driven by,drives\n"));
  CHECK(contains(csv, ",the PLC,\"track CV1, track CV2\"\n"));
  CHECK(contains(csv, ",parts at CV1,\n"));
}

}  // namespace
}  // namespace symplant::test

// Devices by their symbols, rows that are I/O by `io`, prefixes of lists, `plain` symbols, and `exclude` of links.
#include <nlohmann/json.hpp>
#include <string>

#include "app_support.hpp"

namespace symplant::test {
namespace {

using Catch::Matchers::ContainsSubstring;
using Json = nlohmann::json;

MemoryFileSystem tank(const std::string& rest) {
  MemoryFileSystem files;
  files.files["list.csv"] =
      "Name,Address,Type\noTank_Fill,%QX0.0,BOOL\niTank_Full,%IX0.0,BOOL\niTank_Level,%IW2,INT\n"
      "Main_Start,%M200.0,BOOL\nMain_Run,%M200.1,BOOL\nL_S2_PUMP_O_RUN,%QX0.1,BOOL\nL_S2_PUMP_I_RUN,%IX0.1,BOOL\n"
      "L_S2_PUMP_O_DIR,%QX0.2,BOOL\n";
  files.files["plant.json"] = "{\"symplant\": 1, \"symbols\": [\"list.csv\"], " + rest + "}";
  return files;
}

ToolRun model(const std::string& rest, const std::vector<std::string>& options = {}) {
  MemoryFileSystem files = tank(rest);
  std::vector<std::string> arguments = {"model", "plant.json", "--format", "json"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_tool(arguments, files);
}

Json unit_of(const ToolRun& run, const std::string& path) {
  INFO(run.err);
  REQUIRE(run.code == 0);
  const Json plant = Json::parse(run.out);
  for (const Json& unit : plant.at("units")) {
    if (unit.at("path") == path) return unit;
  }
  FAIL("no device " << path);
  return {};
}

std::string first_error(const std::string& rest) {
  MemoryFileSystem files = tank(rest);
  const ToolRun run = run_tool({"check", "plant.json"}, files);
  CHECK(run.code != 0);
  const std::size_t begin = run.out.find("error: ");
  REQUIRE(begin != std::string::npos);
  return run.out.substr(begin, run.out.find('\n', begin) - begin);
}

const std::string kTank =
    R"("devices": { "L_S2_TANK": { "operations": { "FULL": "oTank_Fill" },
                                   "events": { "FULL": "iTank_Full", "LEVEL": "iTank_Level" } } })";

TEST_CASE("A device is made of the symbols that plant.json names, whatever their names") {
  const Json tank_unit = unit_of(model(kTank), "L_S2_TANK");
  CHECK(tank_unit.at("line") == "L");
  CHECK(tank_unit.at("process") == "S2");
  CHECK(tank_unit.at("S").dump() ==
        R"([{"name":"NOT_FULL"},{"event":"iTank_Full","name":"FULL","operation":"oTank_Fill"}])");
  CHECK(tank_unit.at("values") == Json::array({"iTank_Level"}));
}

TEST_CASE("Given symbols leave the device of their names, and join a device of this path") {
  const ToolRun run = model(
      R"("devices": { "L_S2_PUMP": { "events": { "FULL": "iTank_Full" } }, "L_S2_VALVE": { "operations": { "OPEN": "L_S2_PUMP_O_DIR" } } })");
  CHECK(unit_of(run, "L_S2_PUMP").at("O").size() == 2);
  CHECK(unit_of(run, "L_S2_PUMP").at("I").size() == 1);
  CHECK(unit_of(run, "L_S2_VALVE").at("I").size() == 1);
}

TEST_CASE("The entry of such a device gives its states and times, and conditions name it") {
  const ToolRun run = model(
      R"("devices": { "TANK": { "operations": { "FILL": "oTank_Fill" }, "events": { "FULL": "iTank_Full" },
           "states": ["EMPTY"], "initial": "EMPTY", "only": true,
           "transitions": [ { "from": "EMPTY", "to": "FULL", "on": "FILL", "takes": "3s", "when": "L_S2_PUMP.RUN" } ] } })");
  const Json unit = unit_of(run, "TANK");
  CHECK(unit.at("initial") == "EMPTY");
  CHECK(unit.at("d_ext").size() == 1);
}

TEST_CASE("A device by its symbols is a unit under a naming rule with facets, in list order") {
  const ToolRun run =
      model(kTank + R"(, "naming": { "rules": [ { "pattern": "L_{process}_{device}_{direction}_{task}" } ] })");
  const Json plant = Json::parse(run.out);
  REQUIRE(plant.at("units").size() >= 2);
  CHECK(plant.at("units")[0].at("path") == "L_S2_TANK");
  CHECK(plant.at("units")[1].at("path") == "S2_PUMP");
}

TEST_CASE("A symbol in two devices, an unknown one, one of the other direction, and a pattern are errors") {
  CHECK_THAT(
      first_error(
          R"("devices": { "A": { "events": { "X": "iTank_Full" } }, "B": { "events": { "X": "iTank_Full" } } })"),
      ContainsSubstring("`iTank_Full` is given twice; remove one"));
  CHECK_THAT(first_error(R"("devices": { "A": { "events": { "X": "iTank_Ful" } } })"),
             ContainsSubstring("symbol `iTank_Ful` not found; did you mean `iTank_Full`?"));
  CHECK_THAT(first_error(R"("devices": { "A": { "events": { "X": "oTank_Fill" } } })"),
             ContainsSubstring("`oTank_Fill` is an operation, which the PLC writes; move it to `operations`"));
  CHECK_THAT(first_error(R"("devices": { "A": { "operations": { "X": "iTank_Full" } } })"),
             ContainsSubstring("move it to `events`"));
  CHECK_THAT(first_error(R"("devices": { "A*": { "events": { "X": "iTank_Full" } } })"),
             ContainsSubstring("`A*` is a pattern; write an entry for each device"));
  CHECK_THAT(first_error(R"("devices": { "A": { "events": { "X": "iTank_Full" } } }, "plain": ["iTank_Full"])"),
             ContainsSubstring("is also in `plain`"));
  CHECK_THAT(
      first_error(
          R"("devices": { "A": { "events": { "X": "iTank_Full" } } }, "follow": { "iTank_Full": "L_S2_PUMP.RUN" })"),
      ContainsSubstring("also follows a condition"));
}

TEST_CASE("Of two symbols with one task the one of the entry counts") {
  const Json unit =
      unit_of(model(R"("devices": { "L_S2_PUMP": { "operations": { "RUN": "L_S2_PUMP_O_DIR" } } })"), "L_S2_PUMP");
  CHECK(unit.at("I") == Json::parse(R"(["L_S2_PUMP_O_DIR"])"));
}

TEST_CASE("The clock of a link cannot be excluded") {
  MemoryFileSystem files = tank(
      R"("links": [ { "url": "modbus-tcp-server://127.0.0.1:502", "clock": { "of": "PLC_MS" }, "exclude": ["PLC*"] } ])");
  files.files["list.csv"] += "PLC_MS,%QD4,DINT\n";
  CHECK_THAT(run_tool({"check", "plant.json"}, files).out,
             ContainsSubstring("the clock of the link, `PLC_MS`, is excluded; make the pattern narrower"));
}

TEST_CASE("Plain symbols belong to no device") {
  const ToolRun with = model(kTank + R"(, "plain": ["*_DIR"])");
  CHECK(unit_of(with, "L_S2_PUMP").at("I").size() == 1);
  CHECK_THAT(with.out, ContainsSubstring(R"("unmodelled": "plain")"));
  CHECK(unit_of(model(kTank), "L_S2_PUMP").at("I").size() == 2);
  CHECK_THAT(first_error(R"("plain": ["iTank_Level"])"), ContainsSubstring("only BOOL symbols can be in `plain`"));
}

TEST_CASE("Rows in the PLC's memory are I/O if plant.json or --io says so") {
  const std::string io = R"("io": { "events": ["%M200.1"], "operations": ["Main_St*"] }, )";
  const std::string device =
      R"("devices": { "MAIN": { "operations": { "RUN": "Main_Start" }, "events": { "RUN": "Main_Run" } } })";
  CHECK(unit_of(model(io + device), "MAIN").at("S").size() == 2);
  CHECK(unit_of(model(device, {"--io", "events=*_Run", "--io", "operations=%M200.0"}), "MAIN").at("S").size() == 2);
  CHECK(model(device).code == 2);  // they are internal
  CHECK_THAT(first_error(R"("io": { "events": ["Main_*"], "operations": ["%M200.0"] })"),
             ContainsSubstring("`%M200.0` matches `Main_Start`, which is also given the other direction"));
  MemoryFileSystem files = tank(R"("io": { "events": ["iTank*"] })");
  CHECK_THAT(run_tool({"check", "plant.json"}, files).out,
             ContainsSubstring("`iTank*` matches no row whose address is internal or missing"));
  const ToolRun wrong = run_tool({"check", "plant.json", "--io", "Main*"}, files);
  CHECK(wrong.code == 2);
  CHECK_THAT(wrong.err, ContainsSubstring("write events=PATTERN,.. or operations=PATTERN,.."));
}

TEST_CASE("With a prefix several lists may have symbols and devices of one name") {
  MemoryFileSystem files;
  files.files["one.csv"] = list_text({{"L_P_D_O_RUN", "Y0"}, {"L_P_D_I_RUN", "X0"}});
  files.files["plant.json"] = R"({"symplant": 1, "symbols": [
      {"file": "one.csv", "controller": "A", "prefix": "A_"}, {"file": "one.csv", "controller": "B", "prefix": "B_"}],
      "requirements": [ { "name": "r", "never": "A_L_P_D.RUN and B_L_P_D_O_RUN" } ] })";
  const ToolRun run = run_tool({"model", "plant.json", "--format", "json"}, files);
  CHECK(unit_of(run, "A_L_P_D").at("line") == "A_L");
  CHECK(unit_of(run, "B_L_P_D").at("I").size() == 1);
  files.files["plant.json"] = R"({"symplant": 1, "symbols": [
      {"file": "one.csv", "controller": "A"}, {"file": "one.csv", "controller": "B"}]})";
  CHECK_THAT(run_tool({"check", "plant.json"}, files).out, ContainsSubstring("`prefix`"));
}

TEST_CASE("A name with a prefix that breaks the naming rule is reported as the list has it") {
  MemoryFileSystem files;
  files.files["one.csv"] = list_text(bits({"L_P_D_O_RUN", "L_P_D_I_RUN", "L_P_D_X_RUN"}));
  files.files["plant.json"] = R"({"symplant": 1, "symbols": [{"file": "one.csv", "prefix": "A_"}]})";
  CHECK_THAT(run_tool({"check", "plant.json"}, files).out,
             ContainsSubstring("`A_L_P_D_X_RUN` has `X` where its direction belongs"));
}

TEST_CASE("A link leaves out the symbols that it excludes") {
  MemoryFileSystem files = tank(
      R"("links": [ { "url": "modbus-tcp-server://127.0.0.1:502", "exclude": ["%QX0.*", "none*"],
                      "map": [ { "symbol": "L_S2_PUMP_I_RUN", "number": 7 } ] } ])");
  const ToolRun map = run_tool({"map", "plant.json", "--format", "csv"}, files);
  CHECK(map.code == 0);
  CHECK(map.out.find("coil") == std::string::npos);
  CHECK_THAT(map.out, ContainsSubstring("discrete input"));
  CHECK_THAT(run_tool({"map", "plant.json"}, files).out, ContainsSubstring("on no link: 3 excluded by plant.json"));
  CHECK_THAT(run_tool({"check", "plant.json"}, files).out,
             ContainsSubstring("`none*` matches no symbol of the link by name or address"));
}

}  // namespace
}  // namespace symplant::test

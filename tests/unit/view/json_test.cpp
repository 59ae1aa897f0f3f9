// Compares the JSON form with its published schema.
#include <nlohmann/json.hpp>

#include "base/process.hpp"
#include "support/temporary_folder.hpp"
#include "symplant/json/schema.hpp"
#include "view_support.hpp"

namespace symplant::test {
namespace {

using Json = nlohmann::json;

const std::string kSchemaFile = std::string(SYMPLANT_SOURCE_DIR) + "/generator/view/model.schema.json";

std::string faults(const Json& value) {
  const json::Schema schema(read_bytes(kSchemaFile));
  std::string text;
  for (const json::Fault& fault : schema.check(value)) text += fault.pointer + ": " + fault.message + "\n";
  return text;
}

TEST_CASE("The output of --format json matches its schema") {
  CHECK(faults(Json::parse(render(described_cell(), "json").text)) == "");
  CHECK(faults(Json::parse(render(hostile_cell(), "json").text)) == "");
  CHECK(faults(Json::parse(render(cell_with_parts(), "json").text)) == "");
  CHECK(faults(Json::parse(render(plant_with_material(), "json").text)) == "");
  CHECK(faults(Json::parse(render(compile_rows({{"START", "X1"}}), "json").text)) == "");
}

TEST_CASE("The schema rejects another version, an unknown key and a missing one") {
  const Json good = Json::parse(render(described_cell(), "json").text);
  Json bad = good;
  bad["symplant-model"] = 2;
  CHECK(contains(faults(bad), "/symplant-model"));
  bad = good;
  bad["units"][0]["colour"] = "red";
  CHECK(contains(faults(bad), "/units/0"));
  bad = good;
  bad["units"][0]["d_ext"][0].erase("takes");
  CHECK(contains(faults(bad), "/units/0/d_ext/0"));
}

void collect_keys(const Json& schema, std::string& keys) {
  if (schema.is_object()) {
    for (const auto& [key, value] : schema.items()) {
      keys += " " + key + " ";
      collect_keys(value, keys);
    }
  }
  if (schema.is_array()) {
    for (const Json& value : schema) collect_keys(value, keys);
  }
}

TEST_CASE("The schema uses only keywords that every checker supports") {
  std::string keys;
  collect_keys(Json::parse(read_bytes(kSchemaFile)), keys);
  for (const char* keyword : {" pattern ", " patternProperties ", " format "}) CHECK_FALSE(contains(keys, keyword));
}

TEST_CASE("Python's jsonschema agrees, if it is installed") {
  base::SystemProcessRunner runner;
  if (!runner.run({"python3", {"-c", "import jsonschema"}})) {
    WARN("python3-jsonschema is not installed");
    return;
  }
  const std::string program =
      "import json, jsonschema, sys\n"
      "schema = json.load(open(sys.argv[1]))\n"
      "jsonschema.Draft7Validator.check_schema(schema)\n"
      "jsonschema.Draft7Validator(schema).validate(json.load(sys.stdin))\n";
  for (const CompiledText& plant : {described_cell(), hostile_cell(), plant_with_material()}) {
    const std::string text = render(plant, "json").text;
    CHECK(runner.run({"python3", {"-c", program, kSchemaFile}, text, std::chrono::seconds(60)}));
  }
  CHECK_FALSE(runner.run({"python3", {"-c", program, kSchemaFile}, "{}", std::chrono::seconds(60)}));
}

TEST_CASE("The JSON form contains everything in a description, exactly") {
  const Json model = Json::parse(render(described_cell(), "json").text);
  const Json& agv = model.at("units")[0];
  CHECK(agv.at("line") == "L");
  CHECK(agv.at("process") == "P");
  CHECK(agv.at("initial_from") == "description");
  CHECK(agv.at("S")[2] == Json({{"name", "DOCK"}}));
  const Json& docking = agv.at("d_ext")[3];
  CHECK(docking == Json({{"place", 3},
                         {"from", "P2"},
                         {"to", "DOCK"},
                         {"on", "L_P_AGV_O_CHARGE"},
                         {"once", true},
                         {"after", 0},
                         {"takes", {{"mean", 4'000'000'000}, {"sigma", 100'000'000}}},
                         {"origin", "given"}}));
  CHECK(agv.at("d_ext")[4].at("when") == "not (L_P_MC.RUN2 or L_Q_DOOR.OPEN1) and LEVEL < 2.5");
  CHECK(agv.at("l_enter").at("DOCK") == Json::parse(R"([{"event": "L_P_AGV_I_BUSY", "on": true}])"));
  CHECK(agv.at("disabled_by") == Json::parse(R"([{"unit": "L_P_MC", "state": "RUN2"}])"));
  const Json& machine = model.at("units")[1];
  CHECK(machine.at("l_disable") == Json::parse(R"({"RUN2": ["L_P_AGV", "L_Q_DOOR"]})"));
  CHECK(machine.at("d_int")[0].at("after") == 5'000'000'000);
  const Json& stopper = model.at("units")[2];
  CHECK(stopper.at("type") == "Stopper");
  CHECK(stopper.at("behaviour").at("class") == "MyStopper");
  CHECK(stopper.at("behaviour").at("inputs")[0].at("condition") == "L_P_AGV.P2 and not L_P_AGV.moving");
  CHECK(stopper.at("behaviour").at("values")[0] == "L_Q_STOPPER1_I_WEIGHT");
  CHECK(stopper.at("d_int")[0].at("spring_way") == true);
  CHECK(stopper.at("rest") == "RET");
  CHECK(model.at("requirements")[1].at("within") == 500'000'000);
  const auto symbol = [&](const std::string& name) {
    for (const Json& row : model.at("symbols")) {
      if (row.at("name") == name) return row;
    }
    return Json();
  };
  CHECK(symbol("LEVEL").at("initial") == 1.5);
  CHECK(symbol("BIG").at("initial") == "18446744073709551615");
  CHECK(symbol("L_Q_STOPPER1_I_WEIGHT").at("initial") == -5);
  CHECK(symbol("START").at("unmodelled") == "no-rule");
  const Json hostile = Json::parse(render(hostile_cell(), "json").text);
  CHECK(hostile.at("units")[0].at("behaviour").at("class") == "OwnHarm");
}

}  // namespace
}  // namespace symplant::test

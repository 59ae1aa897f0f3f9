// plant.json through the whole tool: files, locations, exit codes.
#include <nlohmann/json.hpp>

#include "app_support.hpp"
#include "description/plant_schema.hpp"
#include "naming/naming_file.hpp"

namespace symplant::test {
namespace {

using nlohmann::json;

MemoryFileSystem cell(const std::string& plant) {
  MemoryFileSystem files = lists();
  files.files["cell/plant.json"] = plant;
  files.files["cell/symbols.csv"] = excell();
  return files;
}

ToolRun run_cell(std::vector<std::string> arguments, const std::string& plant) {
  MemoryFileSystem files = cell(plant);
  arguments.push_back("cell/plant.json");
  return run_tool(arguments, files);
}

std::string cell_with(const std::string& members) {
  return "{\n  \"symplant\": 1,\n  \"symbols\": [\"symbols.csv\"],\n  " + members + "\n}\n";
}

/// "rule line:column message", one per line.
std::string findings(const std::string& plant) {
  const ToolRun run = run_cell({"check", "--format", "json"}, plant);
  const json report = json::parse(run.out);
  std::string text;
  for (const json& finding : report.at("findings")) {
    if (finding.at("rule").get<std::string>().rfind("SP6", 0) != 0) continue;
    text += finding.at("rule").get<std::string>() + " " + std::to_string(finding.value("line", 0)) + ":" +
            std::to_string(finding.value("column", 0)) + " " + finding.at("message").get<std::string>() + "\n";
  }
  return text;
}

TEST_CASE("Every command accepts a plant.json with its lists") {
  const std::string plant = cell_with(R"("name": "press", "devices": {"EXLINE_MB_AGV": {"actuation": "held"}})");
  for (const char* command : {"check", "model", "map"}) {
    const ToolRun run = run_cell({command}, plant);
    INFO(command << run.out << run.err);
    CHECK(run.code == 0);
  }
  CHECK(json::parse(run_cell({"model", "--format", "json"}, plant).out).at("plant") == "press");
  CHECK(json::parse(run_cell({"model", "--format", "json"}, plant).out).at("units")[0].at("actuation") == "held");
  CHECK(run_cell({"run", "--until", "5s"}, plant).code == 0);
  MemoryFileSystem files = cell(plant);
  CHECK(run_tool({"generate", "cell/plant.json", "-o", "out", "--depfile", "out.d"}, files).code == 0);
  CHECK(files.files["out.d"].find("cell/plant.json \\\n  cell/symbols.csv") != std::string::npos);
}

TEST_CASE("Without a name the plant has the name of its file") {
  CHECK(json::parse(run_cell({"model", "--format", "json"}, cell_with("\"links\": []")).out).at("plant") == "plant");
}

TEST_CASE("A plant.json is recognized by its content too, in UTF-16 and UTF-8") {
  MemoryFileSystem files = lists();
  const std::string plant = R"({"symplant": 1, "symbols": ["excell.csv"]})";
  std::string wide = "\xFF\xFE";
  for (const char c : plant) wide += std::string{c, '\0'};
  files.files["a.plant"] = plant;
  files.files["b.json"] = "\xEF\xBB\xBF" + plant;
  files.files["c.json"] = wide;
  for (const char* name : {"a.plant", "b.json", "c.json"}) {
    const ToolRun run = run_tool({"check", name}, files);
    INFO(name << run.out << run.err);
    CHECK(run.code == 0);
  }
}

TEST_CASE("Options of one list apply to that list only, command line options fill the gaps") {
  MemoryFileSystem files = lists();
  files.files["p.json"] = R"({"symplant": 1, "symbols": [{"file": "excell.csv", "xy": "octal"}]})";
  CHECK(contains(run_tool({"check", "--verbose", "p.json"}, files).err, "count in"));
  files.files["q.json"] = R"({"symplant": 1, "symbols": ["excell.csv"]})";
  CHECK(run_tool({"check", "q.json", "--input-format", "tape"}, files).code == 2);
  files.files["r.json"] = R"({"symplant": 1, "symbols": [{"file": "excell.csv", "format": "gx-iec"}]})";
  CHECK(run_tool({"check", "r.json", "--input-format", "tape"}, files).code == 0);
}

TEST_CASE("check ends with 2 for faults of form, with 1 for other faults of the description") {
  CHECK(run_cell({"check"}, "{").code == 2);
  CHECK(run_cell({"check"}, cell_with("\"device\": {}")).code == 2);
  CHECK(run_cell({"check"}, cell_with(R"("devices": {"EXLINE_MB_AGW": {}})")).code == 1);
  CHECK(run_cell({"check"}, cell_with(R"("devices": {"*_AGW": {}})")).code == 0);
  CHECK(run_cell({"check", "--fail-on", "warning"}, cell_with(R"("devices": {"*_AGW": {}})")).code == 1);
  for (const char* command : {"model", "map", "run"}) {
    CHECK(run_cell({command}, cell_with(R"("devices": {"EXLINE_MB_AGW": {}})")).code == 2);
    CHECK(run_cell({command}, cell_with(R"("devices": {"*_AGW": {}})")).code == 0);
  }
}

TEST_CASE("An unreadable list is reported together with faults of form") {
  MemoryFileSystem files = cell(R"({"symplant": 1, "symbols": ["missing.csv", "empty.csv"], "nam": "x"})");
  files.files["cell/empty.csv"] = "";
  const ToolRun run = run_tool({"check", "cell/plant.json"}, files);
  CHECK(run.code == 2);
  CHECK(contains(run.out, "cell/missing.csv"));
  CHECK(contains(run.out, "[SP103 empty-file]"));
  CHECK(contains(run.out, "the key `nam` is unknown here; did you mean `name`?"));
}

TEST_CASE("Faults have line and column, in conditions those of the faulty name") {
  CHECK(findings(cell_with(R"("devices": {
    "EXLINE_MB_AGV": { "initial": "P9", "transitions": [ { "from": "P1", "to": "P2",
      "when": "EXLINE_MB_MC.RUN2 and not EXLINE_MB_MD.IDLE1" } ] } })")) ==
        "SP602 5:35 state `P9` of `EXLINE_MB_AGV` not found; did you mean `P1`?\n"
        "SP606 6:42 device `EXLINE_MB_MD` not found; did you mean `EXLINE_MB_MC`?\n");
}

TEST_CASE("A column counts characters, and escapes in a condition as written") {
  CHECK(findings(cell_with(
            "\"requirements\": [ { \"name\": \"\u00e4\u00f6\", \"never\": \"'EXLINE\\u005fMB_MC'.RUN2 and X\" } ]")) ==
        "SP606 4:76 symbol `X` not found\n");
}

TEST_CASE("Faults of form and of names are reported in one run, without their consequences") {
  // AGV's `state` is unknown, so its missing DOCK is not reported; MC's fault is.
  CHECK(findings(cell_with(R"("devices": {
    "EXLINE_MB_AGV": { "state": ["DOCK"], "initial": "DOCK" },
    "EXLINE_MB_MC": { "initial": "RUN1" } })")) ==
        "SP601 5:24 the key `state` is unknown here; did you mean `states`?\n"
        "SP602 6:34 state `RUN1` of `EXLINE_MB_MC` not found; did you mean `RUN2`?\n");
}

TEST_CASE("A duplicate key is reported with both locations, and nothing is made") {
  const ToolRun run = run_cell({"check"}, cell_with(R"("name": "a",
  "name": "b")"));
  CHECK(run.code == 2);
  CHECK(contains(run.out, "cell/plant.json:5:3: error: the key `name` is repeated"));
  CHECK(contains(run.out, "cell/plant.json:4:3: note:"));
}

TEST_CASE("The option --verbose reports the plant's name and how many devices each pattern matches") {
  const ToolRun run = run_cell({"check", "--verbose"}, cell_with(R"("devices": {"EXLINE_*": {"actuation": "held"}})"));
  CHECK(contains(run.err, "decided: the plant is called plant\n"));
  CHECK(contains(run.err, "decided: `EXLINE_*` matches 2 devices\n"));
  CHECK(contains(run_cell({"check", "--verbose"}, cell_with(R"("times": {"*_AGV": {}})")).err,
                 "decided: `*_AGV` of `times` matches 1 device\n"));
}

TEST_CASE("No output may replace an input file of the plant") {
  MemoryFileSystem files = cell(cell_with("\"name\": \"x\""));
  const std::string folder = std::string(SYMPLANT_SOURCE_DIR) + "/examples/excell/excell.csv";
  files.files["cell/plant.json"] = "{\"symplant\": 1, \"symbols\": [\"" + folder + "\"]}";
  files.files[folder] = excell();
  CHECK(run_tool({"model", "cell/plant.json", "-o", folder}, files).code == 2);
  CHECK(run_tool({"check", "cell/plant.json", "--output", folder}, files).code == 2);
}

TEST_CASE("schema prints the schema of plant.json, and reports an unknown name") {
  const ToolRun run = run_tool({"schema", "plant"});
  CHECK(run.code == 0);
  CHECK(run.out == description::plant_schema());
  CHECK(json::parse(run.out).at("$schema") == "http://json-schema.org/draft-07/schema#");
  CHECK(run_tool({"schema", "naming"}).out == naming::naming_schema());
  CHECK(contains(run_tool({"schema", "palnt"}).err, "`palnt` is not a format"));
}

TEST_CASE("schema prints each format that its help and its message name") {
  const std::string formats = "plant, scenario, naming, model or suite";
  CHECK(contains(run_tool({"schema", "--help"}).out, formats));
  CHECK(contains(run_tool({"schema", "links"}).err, ": write " + formats + "\n"));
  for (const char* format : {"plant", "scenario", "naming", "model", "suite"}) {
    INFO(format);
    CHECK(json::parse(run_tool({"schema", format}).out).contains("$schema"));
  }
}

TEST_CASE("Hostile files end with 2 and a message") {
  const std::string deep = std::string(100'000, '[');
  const std::string name(20'000, 'N');
  const std::vector<std::string> hostile{
      "",
      " \n",
      "\xEF\xBB\xBF",
      "null",
      "[]",
      "{}",
      "{\"symplant\": 1}",
      "{\"symplant\": 1, \"symbols\": [\"symbols.csv\"], \"name\": \"a\\u0000b\"}",
      "{\"symplant\": 1, \"symbols\": [\"symbols.csv\"], \"name\": \"\\ud800\"}",
      "{\"symplant\": 1, \"symbols\": [\"symbols.csv\"], \"x\": " + deep,
      "{\"symplant\": 1, \"symbols\": [\"symbols.csv\"], \"" + name + "\": 1}",
      "{\"symplant\": 1e999, \"symbols\": [\"symbols.csv\"]}",
      "{\"symplant\": 1, \"symbols\": [\"" + name + "\"]}",
      "{\"symplant\": 1, \"symbols\": [\"../../../etc\"]}",
      std::string("{\0}", 3),
      "{\"symplant\": 1, \"symbols\": [\"symbols.csv\"], \"name\": \"\xFF\"}",
  };
  for (const std::string& text : hostile) {
    const ToolRun run = run_cell({"check"}, text);
    INFO(text.substr(0, 80) << " ... " << run.out.substr(0, 300));
    CHECK(run.code == 2);
    CHECK(contains(run.out, "error: "));
  }
  const ToolRun run =
      run_cell({"check"}, cell_with("\"devices\": {\"" + name + "\": {\"initial\": \"" + name + "\"}}"));
  CHECK(run.code == 1);
}

TEST_CASE("The expected content is reported for a damaged plant.json, not for a list") {
  CHECK(contains(run_cell({"check"}, "").out, "is empty; a plant description begins as `{ \"symplant\": 1"));
  const ToolRun run = run_cell({"check"}, "{ \"symplant\": 1, \"name\": \"\xE4\" }");
  CHECK(contains(run.out, "save it as UTF-8 [SP102"));
  CHECK_FALSE(contains(run.out, "list"));
}

TEST_CASE("Faults of parts have line and column, those of form no consequences") {
  CHECK(findings(cell_with(R"("material": { "kinds": { "k": { "length": "1 m" } },
    "tracks": { "T": { "length": "2m", "drives": [ { "speed": "1 m/s" } ], "end": "U",
      "stops": [ { "at": "3 m", "when": "EXLINE_MB_AGV.P2 and T.kk" } ] }, "out": { "length": "2 m", "drives": [] } },
    "transfers": [ { "name": "t", "to": "T@9 m" }, { "name": "u", "from": 3, "to": "T" } ],
    "sources": [ { "name": "s", "at": "T", "kind": [ "k", "l" ] }, { "name": "r", "at": "T", "kind": [ 1 ] } ] })")) ==
        "SP602 5:83 track or place `U` not found; did you mean `T`?\n"
        "SP607 6:26 this position is beyond the end of track `T`\n"
        "SP606 6:65 kind of part `kk` not found; did you mean `k`?\n"
        "SP607 6:76 `out` is a reserved word; choose another name\n"
        "SP601 6:102 expected an array of drives, but found an empty array\n"
        "SP601 7:20 the key `from` is missing here; it holds a location of parts\n"
        "SP607 7:41 this position is beyond the end of track `T`\n"
        "SP601 7:75 expected a location of parts, but found the number `3`\n"
        "SP602 8:59 kind of part `l` not found; did you mean `k`?\n"
        "SP601 8:104 expected a kind, but found the number `1`\n");
}

TEST_CASE("Every key of the schema is read, and every key that is read is in the schema") {
  const json schema = json::parse(description::plant_schema());
  const json& device = schema.at("definitions").at("device").at("properties");
  CHECK(device.size() == description::kDeviceKeys + 2);  // and the symbols, `operations` and `events`
  for (std::size_t k = 0; k < description::kDeviceKeys; ++k) {
    CHECK(device.contains(std::string(description::device_key_name(static_cast<description::DeviceKey>(k)))));
  }
}

TEST_CASE("The order of keys does not matter") {
  const ToolRun one =
      run_cell({"model", "--format", "json"}, cell_with(R"("name": "n", "defaults": {"travel": "2s"})"));
  const ToolRun other =
      run_cell({"model", "--format", "json"},
               R"({"defaults": {"travel": "2s"}, "name": "n", "symbols": ["symbols.csv"], "symplant": 1})");
  CHECK(one.code == 0);
  CHECK(one.out == other.out);
}

}  // namespace
}  // namespace symplant::test

// Naming rules of commands: files, profiles, values of plant.json, links.
#include "naming/load.hpp"

#include <string>

#include "app/read_inputs.hpp"
#include "diag/text.hpp"
#include "support/catch.hpp"
#include "support/compile.hpp"
#include "support/golden.hpp"
#include "support/strings.hpp"
#include "support/tool.hpp"

namespace symplant::test {
namespace {

const std::string kNaming = R"({"symplant-naming": 1, "rules": [{"pattern": "{device}_{direction}_{task}"}]})";

MemoryFileSystem plant_with(const std::string& naming_member) {
  MemoryFileSystem files;
  files.files["cell/list.csv"] = list_text(bits({"L_P_D_O_RUN", "L_P_D_I_RUN"}));
  files.files["cell/plant.json"] =
      "{\"symplant\": 1, \"symbols\": [\"list.csv\"]" + (naming_member.empty() ? "" : ", " + naming_member) + "}";
  return files;
}

struct ReadPlant {
  std::optional<app::Inputs> inputs;
  std::string findings;
};

ReadPlant read(const MemoryFileSystem& files, const std::string& option = {},
               const std::string& plant = "cell/plant.json") {
  app::CompileOptions options{plant, {}, {}};
  options.naming = option;
  std::ostringstream err;
  app::Progress progress(err, false);
  diag::Diagnostics diagnostics;
  ReadPlant result;
  result.inputs = app::read_inputs(options, files, progress, diagnostics);
  result.findings = diag::render_text(diagnostics.all(), {.all = true});
  return result;
}

std::string rule_name(const ReadPlant& plant) {
  INFO(plant.findings);
  REQUIRE(plant.inputs);
  return plant.inputs->naming->naming().name;
}

TEST_CASE("Without --naming and without the key the profile strict applies") {
  CHECK(rule_name(read(plant_with(""))) == "strict");
}

TEST_CASE("A naming rule is a file relative to plant.json, a profile, or a value of plant.json") {
  MemoryFileSystem files = plant_with(R"("naming": "rules/own.json")");
  files.files["cell/rules/own.json"] = R"({"symplant-naming": 1, "name": "own", "rules": [{"pattern": "{device}"}]})";
  CHECK(rule_name(read(files)) == "own");
  CHECK(read(files).inputs->naming_parts->files == std::vector<std::string>{"cell/rules/own.json"});
  CHECK(rule_name(read(plant_with(R"("naming": "@ls-body")"))) == "ls-body");
  CHECK(rule_name(read(plant_with(R"("naming": {"name": "inside", "rules": [{"pattern": "{device}"}]})"))) == "inside");
}

TEST_CASE("The option --naming wins over plant.json, and its path is relative to the current folder") {
  MemoryFileSystem files = plant_with(R"("naming": "@ls-body")");
  files.files["own.json"] = R"({"symplant-naming": 1, "name": "own", "rules": [{"pattern": "{device}"}]})";
  CHECK(rule_name(read(files, "own.json")) == "own");
  CHECK(rule_name(read(files, "@strict")) == "strict");
  CHECK(rule_name(read(files, "@strict", "cell/list.csv")) == "strict");
}

TEST_CASE("Faults are located in the file that has the rule") {
  MemoryFileSystem files = plant_with(R"("naming": "own.json")");
  files.files["cell/own.json"] = "{\"symplant-naming\": 1,\n \"rules\": [{\"pattern\": \"{device\"}]}";
  const ReadPlant broken = read(files);
  CHECK_FALSE(broken.inputs);
  CHECK(contains(broken.findings, "cell/own.json:2:24: error: `{` without `}`"));
  const ReadPlant inside = read(plant_with(R"("naming": {"rules": [{"pattern": {"comment": "{devise}"}}]})"));
  CHECK_FALSE(inside.inputs);
  CHECK(contains(inside.findings, "cell/plant.json:1:"));
  CHECK(contains(inside.findings, "unknown field `{devise}`; did you mean `{device}`? [SP609 naming-contradiction]"));
}

TEST_CASE("An unknown profile and a missing file are reported") {
  CHECK(contains(read(plant_with(R"("naming": "@ls-boddy")")).findings,
                 "cell/plant.json:1:52: error: unknown naming profile `@ls-boddy`; did you mean `ls-body`? [SP609"));
  CHECK(contains(read(plant_with(""), "@x").findings, "unknown naming profile `@x`; `symplant naming` lists all"));
  CHECK(contains(read(plant_with(R"("naming": "own.json")")).findings, "cannot read `cell/own.json`"));
  CHECK(contains(read(plant_with(""), "own.json").findings, "cannot read `own.json`"));
}

TEST_CASE("Links are read from a table next to the naming rule") {
  MemoryFileSystem files = plant_with(R"("naming": "rules/own.json")");
  files.files["cell/rules/own.json"] =
      R"({"symplant-naming": 1, "links": "links.csv", "rules": [{"pattern": "{device}"}]})";
  files.files["cell/rules/links.csv"] = "State;Operation;Event\nADV;O1;E1\n\nADV;;\"E;2\"\n";
  const ReadPlant plant = read(files);
  INFO(plant.findings);
  REQUIRE(plant.inputs);
  const auto& links = plant.inputs->naming->naming().links;
  REQUIRE(links.size() == 2);
  CHECK(links[0].operation == "O1");
  CHECK(links[1].operation.empty());
  CHECK(links[1].event == "E;2");
  const naming::LoadedNaming& parts = *plant.inputs->naming_parts;
  CHECK(parts.files == std::vector<std::string>{"cell/rules/own.json", "cell/rules/links.csv"});
  const diag::Location second = parts.link_location(1);
  CHECK(second.source->path() == "cell/rules/links.csv");
  CHECK(second.source->position(second.span.begin).line == 4);
}

TEST_CASE("Comments in a table of links do not count") {
  MemoryFileSystem files = plant_with(R"("naming": "rules/own.json")");
  files.files["cell/rules/own.json"] =
      R"({"symplant-naming": 1, "links": "links.csv", "rules": [{"pattern": "{device}"}]})";
  files.files["cell/rules/links.csv"] =
      "# a, b, c\n#\noperation;event;state\n#O,E,S\n#O2,,S\nO1;E1;ADV\n\"#O2\";E2;ADV\n# end";
  const ReadPlant plant = read(files);
  INFO(plant.findings);
  REQUIRE(plant.inputs);
  const auto& links = plant.inputs->naming->naming().links;
  REQUIRE(links.size() == 2);
  CHECK(links[0].event == "E1");
  CHECK(links[1].operation == "#O2");
}

TEST_CASE("The location of a link without a file is its row in the naming rule") {
  const ReadPlant plant =
      read(plant_with("\"naming\": {\n\"rules\": [{\"pattern\": \"{device}\"}],\n\"links\": [[\"O\", \"E\", \"S\"],\n"
                      "[\"\", \"E2\", \"S\"]]}"));
  INFO(plant.findings);
  REQUIRE(plant.inputs);
  const diag::Location second = plant.inputs->naming_parts->link_location(1);
  CHECK(second.source->path() == "cell/plant.json");
  CHECK(second.source->position(second.span.begin).line == 4);
}

TEST_CASE("Faults of a table of links have its file and row") {
  const auto findings = [](const std::string& links) {
    MemoryFileSystem files = plant_with(R"("naming": "own.json")");
    files.files["cell/own.json"] = R"({"symplant-naming": 1, "links": "l.csv", "rules": [{"pattern": "{device}"}]})";
    files.files["cell/l.csv"] = links;
    const ReadPlant plant = read(files);
    CHECK_FALSE(plant.inputs);
    return plant.findings;
  };
  CHECK(contains(findings(""), "the file of links is empty; its first row is `operation,event,state`"));
  CHECK(contains(findings("operation,evnt,state\nO,E,S\n"),
                 "cell/l.csv:1:11: error: unknown column `evnt`; did you mean "
                 "`event`? [SP608 naming-schema]"));
  CHECK(contains(findings("operation,event\nO,E\n"), "cell/l.csv:1:1: error: the first row lacks `state`"));
  CHECK(contains(findings("operation,event,state\n,E,S\n"), "cell/l.csv:2:1: error: the first row has no operation"));
  CHECK(contains(findings("operation,event,state\nO,E,S\nO,,S\n"), "cell/l.csv:3:1: error: the row has no event"));
  CHECK(contains(findings("operation,event,state\nO,\"E,S\n"), "cell/l.csv:2:3: error: this quote is never closed"));
}

TEST_CASE("Commands take --naming, and its files are inputs") {
  MemoryFileSystem files = plant_with("");
  files.files["own.json"] = kNaming;
  CHECK(run_tool({"model", "cell/plant.json", "--naming", "own.json"}, files).code == 0);
  CHECK(run_tool({"model", "cell/plant.json", "--naming", "missing.json"}, files).code == 2);
  CHECK(run_tool({"check", "cell/plant.json", "--naming", "@unknown"}, files).code == 2);
  const ToolRun made =
      run_tool({"generate", "cell/plant.json", "-o", "out", "--naming", "own.json", "--depfile", "out.d"}, files);
  INFO(made.err);
  CHECK(made.code == 0);
  CHECK(contains(files.files["out.d"], " own.json"));
}

TEST_CASE("naming lists the profiles and prints one") {
  const ToolRun list = run_tool({"naming"});
  CHECK(list.code == 0);
  CHECK(contains(list.out, "\nls-body "));
  const ToolRun one = run_tool({"naming", "@ls-body"});
  CHECK(one.code == 0);
  CHECK(contains(one.out, "\"name\": \"ls-body\""));
  CHECK(run_tool({"naming", "ls-body"}).out == one.out);
  const ToolRun unknown = run_tool({"naming", "ls_body"});
  CHECK(unknown.code == 2);
  CHECK(contains(unknown.err, "unknown naming profile `ls_body`; did you mean `ls-body`?"));
}

}  // namespace
}  // namespace symplant::test

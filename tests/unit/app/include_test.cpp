// Included descriptions and `times` through the whole tool: messages, dependency files, paths.
#include "app_support.hpp"

namespace symplant::test {
namespace {

const std::string kIncluding = R"({
  "symplant": 1,
  "include": ["learned.json"],
  "symbols": ["symbols.csv"]
})";
/// As `symplant learn` writes it.
const std::string kLearned = R"(// Learned from line2.jsonl by symplant.
{
  "symplant": 1,
  "times": {
    // 412 moves in line2.jsonl, resolution 50 ms
    "EXLINE_MB_AGV": {
      "P1->P2": { "takes": "2.1s" },
      "P2->P1": { "takes": { "min": "1.9s", "max": "2.2s" } }
    }
  }
}
)";

MemoryFileSystem learned_cell(const std::string& learned) {
  MemoryFileSystem files = lists();
  files.files["cell/plant.json"] = kIncluding;
  files.files["cell/learned.json"] = learned;
  files.files["cell/symbols.csv"] = excell();
  return files;
}

ToolRun run_learned(const std::vector<std::string>& arguments, MemoryFileSystem files) {
  return run_tool(arguments, files);
}

TEST_CASE("A learned file is included by every command that takes a plant") {
  MemoryFileSystem files = learned_cell(kLearned);
  CHECK(run_learned({"check", "cell/plant.json"}, files).code == 0);
  const ToolRun model = run_learned({"model", "cell/plant.json"}, files);
  CHECK(contains(model.out, "(P1, O_P2) -> P2, takes 2.1 s  [derived]"));
  CHECK(contains(model.out, "(P2, O_P1) -> P1, takes 1.9 s to 2.2 s  [derived]"));
  CHECK(run_learned({"run", "cell/plant.json", "--until", "5s"}, files).code == 0);
  files.files["cell/old.json"] = R"({ "symplant": 1, "symbols": ["symbols.csv"] })";
  CHECK(contains(run_learned({"diff", "cell/old.json", "cell/plant.json"}, files).out, "takes 2.1 s"));
}

TEST_CASE("A dependency file lists the included files, which no output replaces") {
  MemoryFileSystem files = learned_cell(kLearned);
  CHECK(run_tool({"generate", "cell/plant.json", "-o", "out", "--depfile", "out.d"}, files).code == 0);
  CHECK(contains(files.files["out.d"], "cell/plant.json \\\n  cell/learned.json \\\n  cell/symbols.csv"));
  // Whether two paths are one file is asked of the disk.
  const std::string real = std::string(SYMPLANT_SOURCE_DIR) + "/tests/compiled/timed/learned.json";
  files.files["cell/plant.json"] = R"({ "symplant": 1, "symbols": ["symbols.csv"], "include": [")" + real + "\"] }";
  files.files[real] = kLearned;
  CHECK(run_tool({"model", "cell/plant.json", "-o", real}, files).code == 2);
  CHECK(files.files[real] == kLearned);
}

TEST_CASE("Messages name the included file, in form, in names, and if it is empty or missing") {
  const auto checked = [](const std::string& learned) {
    return run_learned({"check", "cell/plant.json"}, learned_cell(learned));
  };
  const ToolRun name = checked(R"({ "symplant": 1, "times": { "EXLINE_MB_AGV": { "P1->P3": {} } } })");
  CHECK(name.code == 1);
  CHECK(
      contains(name.out, "cell/learned.json:1:48: error: state `P3` of `EXLINE_MB_AGV` not found; did you mean `P1`?"));
  const ToolRun form = checked(R"({ "symplant": 1, "tims": {} })");
  CHECK(form.code == 2);
  CHECK(contains(form.out, "cell/learned.json:1:18: error: the key `tims` is unknown here; did you mean `times`?"));
  const ToolRun empty = checked(" \n");
  CHECK(empty.code == 2);
  CHECK(contains(empty.out, "cell/learned.json: error: the file `cell/learned.json` is empty"));
  const ToolRun undecodable = checked("{ \"symplant\": 1, \"name\": \"\xE4\" }");
  CHECK(undecodable.code == 2);
  CHECK(contains(undecodable.out, "cell/learned.json"));
  MemoryFileSystem files = learned_cell("");
  files.files.erase("cell/learned.json");
  const ToolRun missing = run_learned({"check", "cell/plant.json"}, files);
  CHECK(missing.code == 2);
  CHECK(contains(missing.out, "cell/plant.json:3:15: error: cannot read `cell/learned.json`: "));
}

TEST_CASE("Lists and a naming rule of an included file are found next to it") {
  MemoryFileSystem files = learned_cell(kLearned);
  files.files["plant.json"] = R"({ "symplant": 1, "include": ["cell/base.json"] })";
  files.files["cell/base.json"] = R"({ "symplant": 1, "symbols": ["symbols.csv"], "naming": "naming.json" })";
  const ToolRun run = run_tool({"check", "plant.json"}, files);
  CHECK(run.code == 2);
  CHECK(contains(run.out, "cell/naming.json"));
  files.files["cell/base.json"] = R"({ "symplant": 1, "symbols": ["symbols.csv", "none*.csv"] })";
  CHECK(contains(
      run_tool({"check", "plant.json"}, files).out,
      "cell/base.json:1:45: error: no file matches `none*.csv`; correct the path, which is relative to this file"));
  files.files["cell/base.json"] = R"({ "symplant": 1, "symbols": ["symbols.csv"] })";
  CHECK(run_tool({"check", "plant.json"}, files).code == 0);
}

TEST_CASE("Settings of check in an included file are located in it") {
  MemoryFileSystem files =
      learned_cell(R"({ "symplant": 1, "check": { "ignore": [ { "rule": "no-such-rule", "why": "w" } ] } })");
  CHECK(contains(run_tool({"check", "cell/plant.json"}, files).out, "cell/learned.json:1:"));
}

}  // namespace
}  // namespace symplant::test
